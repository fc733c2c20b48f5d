#pragma once

#include <span>

#include "levels/picture/canvas.h"
#include "levels/picture/level_drawing.h"

namespace platon {

/// Draws segments as lines with round ends. `width` is in the units of the lines.
void paintSegments(Canvas& canvas, std::span<const LevelDrawing::Line> lines, Colour ink, double width);

}  // namespace platon
