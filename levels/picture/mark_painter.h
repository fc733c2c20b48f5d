#pragma once

#include <glm/vec2.hpp>

#include "levels/picture/canvas.h"
#include "levels/picture/tints.h"

namespace platon {

// Marks of a level. Lengths are in the units of the canvas's map, directions are unit vectors.

void paintArrow(Canvas& canvas, glm::dvec2 tail, glm::dvec2 head, const Ink& ink, double width);

/// A ball with a mark towards its up.
void paintBall(Canvas& canvas, glm::dvec2 place, glm::dvec2 up, double radius, const Tints& tints);

/// A ring round a dot. `radius` is that of the outer side of the ring.
void paintGoal(Canvas& canvas, glm::dvec2 place, double radius, const Tints& tints);

}  // namespace platon
