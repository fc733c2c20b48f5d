#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "client/editor/edited_segment.h"
#include "platon/game/diagnostics.h"
#include "platon/game/level.h"
#include "platon/game/level_text.h"
#include "platon/game/solid.h"

namespace platon {

/// The text of a level while it is edited. An edit changes only the text lines concerned: comments, blank lines, line
/// ends and the format of numbers elsewhere are kept byte for byte. loadLevel decides what is valid.
class LevelDocument {
 public:
  /// Reads the text. An invalid one has no level(); edits need a text whose header and face marks are complete.
  explicit LevelDocument(std::string_view text);

  std::string text() const;
  /// Segments in the order of the text, as they are written.
  const std::vector<EditedSegment>& segments() const { return segments_; }
  /// Number of the text line of a segment, from 1.
  int textLineOf(std::size_t segment) const { return static_cast<int>(textLines_[segment]) + 1; }

  /// The level of the last valid text; null if there was none.
  const std::shared_ptr<const Level>& level() const { return level_; }
  /// Whether the present text is valid. Else level() is that of an older text.
  bool valid() const { return valid_; }
  /// Errors and warnings of the present text.
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

  /// Reads the present text. Called after one or more edits.
  void check();

  /// Adds a segment after the last one of its face.
  void add(const EditedSegment& segment);
  /// Rewrites the text line of a segment. A comment behind it stays; on another face, it is added there.
  void replace(std::size_t segment, const EditedSegment& with);
  /// Removes the text line of a segment. A comment behind it stays on a text line of its own.
  void erase(std::size_t segment);
  /// Erases each segment whose entry is true, in one pass; one entry for each of segments().
  void erase(const std::vector<bool>& segments);
  void setStart(const FacePlace& start, int degrees);
  /// Changes only the up of the start.
  void turnStart(int degrees);
  void setGoal(const FacePlace& goal);
  /// Replaces the whole text.
  void setText(std::string_view text);

 private:
  void scan();
  void note(const LevelLine& line);
  void rewrite(std::size_t index, const std::vector<std::string>& words);
  std::string_view lineEnd() const;

  std::vector<std::string> lines_;  // with their line ends
  std::vector<EditedSegment> segments_;
  std::vector<std::size_t> textLines_;  // of the segments
  std::vector<std::size_t> header_;     // text lines of solid, start, goal and size
  std::vector<std::size_t> faceMarks_;  // text lines of the '%'
  std::shared_ptr<const Level> level_;
  bool valid_ = false;
  std::vector<Diagnostic> diagnostics_;
};

/// A coordinate as it is written: at most four decimals, no more than are needed.
std::string coordinateText(double units);

/// The text of a new level: a floor, the start and the goal on face 0.
std::string newLevelText(SolidKind solid, const std::string& title);

/// A title made of the name of a level file: `02_half_turn.level` gives `Half turn`.
std::string titleOf(const std::string& fileName);

}  // namespace platon
