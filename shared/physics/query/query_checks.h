#pragma once

#include <stdexcept>
#include <string>

#include "platon/exact/integer.h"
#include "platon/exact/point.h"
#include "platon/physics/map_geometry.h"
#include "platon/physics/world.h"

namespace platon {

/// The map part with this id. Throws std::invalid_argument when it is not initialised.
inline const MapGeometry& partOf(const World& world, std::uint32_t id) {
  if (const MapGeometry* part = world.geometry().find(id)) return *part;
  throw std::invalid_argument("query in map part " + std::to_string(id) + ": the part is not initialised");
}

/// Throws std::invalid_argument when an end of the path is out of range.
inline void requirePath(Point from, Point displacement) {
  const auto isInRange = [](std::int32_t start, std::int32_t change) {
    return isCoordinate(start) && isCoordinate(std::int64_t{start} + change);
  };
  if (isInRange(from.x, displacement.x) && isInRange(from.y, displacement.y)) return;
  throw std::invalid_argument("query from (" + std::to_string(from.x) + ", " + std::to_string(from.y) + ") by (" +
                              std::to_string(displacement.x) + ", " + std::to_string(displacement.y) +
                              "): an end is out of range: coordinates must be below 2^29 in magnitude");
}

}  // namespace platon
