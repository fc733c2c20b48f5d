#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "platon/exact/angle.h"
#include "platon/exact/point.h"
#include "platon/game/diagnostics.h"
#include "platon/game/element.h"
#include "platon/game/solid.h"
#include "platon/game/stage.h"
#include "platon/physics/segment.h"
#include "shared/game/face_area.h"
#include "shared/game/level_number.h"
#include "shared/game/level_text.h"

namespace platon {

/// The start or the goal of a level.
struct LevelPlace {
  std::uint32_t face = 0;
  Point point;
  Angle angle;      ///< start only: from the face's +y to the player's up
  TextPosition at;  ///< position of its x in the text
};

/// The content of a level text. Complete when no error was reported.
struct LevelDraft {
  std::optional<SolidKind> solid;
  std::optional<std::int32_t> faceSize;
  std::optional<LevelPlace> start;
  std::optional<LevelPlace> goal;
  std::vector<std::vector<Segment>> segments;        ///< one list per face once the solid is known; elements first
  std::vector<std::vector<TextPosition>> positions;  ///< of the segments in the text
  std::vector<Element> elements;                     ///< in order of face and segment
  std::string title;
  std::string author;
  std::optional<std::uint32_t> crossings;
  std::optional<std::uint32_t> players;
  std::vector<ElementWord> needs;
  TextPosition needsAt;
};

/// Reads a level text line by line and reports every error, except that it does not check whether the start is free.
class LevelReader {
 public:
  /// Longest title and longest author in bytes.
  static constexpr std::size_t kMaxNameBytes = 100;
  /// Largest number of lines on all faces together.
  static constexpr std::size_t kMaxLines = 200000;
  /// Largest number of lines with a word.
  static constexpr std::size_t kMaxElements = 4096;

  LevelReader(std::string_view text, Diagnostics& diagnostics) : text_(text, diagnostics), diagnostics_(&diagnostics) {}

  LevelDraft read();

 private:
  struct Field;
  struct PlacedSegment {
    std::size_t face;
    Segment segment;
    TextPosition at;
  };
  static constexpr std::size_t kHeaderLines = 4;

  void readLine(const LevelLine& line);
  void readComment(const LevelLine& line);
  void readName(const LevelLine& line, std::string_view key, std::string& name);
  void readCount(const LevelLine& line, std::string_view key, std::uint32_t low, std::optional<std::uint32_t>& count);
  void readNeeds(const LevelLine& line);
  void readHeader(const LevelLine& line);
  void readSolid(const LevelLine& line);
  std::optional<LevelPlace> readPlace(const LevelLine& line, std::string_view what, std::span<const Field> fields);
  void readFaceSize(const LevelLine& line);
  void readFaceMark(const LevelLine& line);
  void readSegment(const LevelLine& line);
  void addSegment(const LevelLine& line, std::span<const LevelNumber> numbers);
  void warnOfShape(TextPosition at, FinePoint a, FinePoint b, const Segment& segment);
  void addElement(const LevelLine& line, const Segment& segment);
  bool readFields(const LevelLine& line, std::string_view what, std::span<const Field> fields,
                  std::span<LevelNumber> numbers);
  bool readField(const LevelLine& line, std::size_t index, const Field& field, LevelNumber& number);

  Field faceField() const;
  void reportMissingHeader(TextPosition at);
  void checkInside(std::optional<LevelPlace>& place, std::string_view what);
  void warnOfDuplicates();
  void putElementsFirst();
  void finish();

  LevelText text_;
  Diagnostics* diagnostics_;
  LevelDraft draft_;
  std::size_t header_ = 0;        // header lines read so far
  std::size_t faces_ = 0;         // '%' read so far
  std::size_t segments_ = 0;      // lines of faces read so far, one segment each
  std::optional<FaceArea> area_;  // set once solid and face size are known, and so are posts_
  std::vector<Post> posts_;
  std::vector<PlacedSegment> placed_;  // every segment of the draft with its position in the text
};

}  // namespace platon
