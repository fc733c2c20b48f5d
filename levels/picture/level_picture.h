#pragma once

#include <set>

#include <glm/vec2.hpp>

#include "levels/picture/canvas.h"
#include "levels/picture/element_painter.h"
#include "platon/game/element.h"
#include "platon/game/level.h"

namespace platon {

/// Draws the legend of a picture: a row of marks with what they mean, and of the kinds of elements that the picture
/// shows. `start` is the middle of its left side. Lengths
/// are in the units of the canvas's map, whose +y points up.
void paintLegend(Canvas& canvas, glm::dvec2 start, const Tints& tints, const std::set<ElementKind>& kinds);

/// Width of a picture of a level, pixels. The height is 5/8 of it.
inline constexpr int kMinPictureWidth = 160;
inline constexpr int kMaxPictureWidth = Canvas::kMaxSize;
inline constexpr int kPictureWidth = 1600;

/// Draws a level: its title, its solid from two opposite sides, and its unfolding, with the same tint for a face in
/// both. docs/level_format.md explains the picture. `width` is between the limits above.
Canvas drawLevel(const Level& level, int width);

}  // namespace platon
