#pragma once

#include <span>

#include "levels/picture/canvas.h"
#include "levels/picture/level_drawing.h"
#include "levels/picture/tints.h"

namespace platon {

/// Draws segments: walls as lines with round ends, and above them elements in patterns of their own. `width` is
/// that of a wall, in the units of the lines.
void paintSegments(Canvas& canvas, std::span<const LevelDrawing::Line> lines, const Tints& tints, double width);

}  // namespace platon
