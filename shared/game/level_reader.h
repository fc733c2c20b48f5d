#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "platon/exact/angle.h"
#include "platon/exact/point.h"
#include "platon/game/diagnostics.h"
#include "platon/game/element.h"
#include "platon/game/solid.h"
#include "platon/physics/segment.h"

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
  /// Longest title and longest author in bytes.
  static constexpr std::size_t kMaxNameBytes = 100;
  /// Largest number of lines on all faces together.
  static constexpr std::size_t kMaxLines = 200000;
  /// Largest number of lines with a word.
  static constexpr std::size_t kMaxElements = 4096;

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
LevelDraft readLevel(std::string_view text, Diagnostics& diagnostics);

}  // namespace platon
