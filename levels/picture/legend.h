#pragma once

#include <set>

#include <glm/vec2.hpp>

#include "levels/picture/canvas.h"
#include "levels/picture/tints.h"
#include "platon/game/element.h"

namespace platon {

/// Draws the legend of a picture: a row of marks with what they mean, and of the kinds of elements that the picture
/// shows. `start` is the middle of its left side. Lengths
/// are in the units of the canvas's map, whose +y points up.
void paintLegend(Canvas& canvas, glm::dvec2 start, const Tints& tints, const std::set<ElementKind>& kinds);

}  // namespace platon
