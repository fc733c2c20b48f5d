#pragma once

#include <optional>
#include <vector>

#include "client/editor/edited_segment.h"
#include "client/editor/level_analysis.h"
#include "client/scene/stage_model.h"

namespace platon {

/// What the editor marks above the segments.
struct EditorMarks {
  std::optional<EditedSegment> hovered;   ///< under the pointer
  std::optional<EditedSegment> selected;  ///< with its ends
  std::vector<EditedSegment> drawn;       ///< not yet part of the level
  std::vector<EditedSegment> faulty;      ///< part of a text that is not valid
  std::optional<FacePlace> pointer;       ///< where the next click takes effect
};

/// Widths are at least that of a segment; `unit` is the length of two pixels of the virtual screen, level units.
FaceMarks marksAbove(const EditorMarks& marks, double unit);

/// A dot wherever a ball may be, and dotted ways to the goal.
FaceMarks marksBelow(const LevelReport& report, bool showReached);

}  // namespace platon
