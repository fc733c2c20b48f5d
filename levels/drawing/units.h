#pragma once

#include <glm/vec2.hpp>

#include "platon/exact/angle.h"
#include "platon/exact/integer.h"
#include "platon/exact/point.h"

namespace platon {

/// Subunits to level units. Exact: every coordinate of the simulation is a double.
inline glm::dvec2 toUnits(Point point) {
  return {double{1} * point.x / kSubunitsPerUnit, double{1} * point.y / kSubunitsPerUnit};
}

/// Angle in radians, counter-clockwise, in [0, 2π).
inline double toRadians(Angle angle) { return angle.centidegrees() * (6.283185307179586 / Angle::kTurn); }

}  // namespace platon
