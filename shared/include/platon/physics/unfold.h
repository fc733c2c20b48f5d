#pragma once

#include <cstdint>
#include <optional>

#include "platon/exact/angle.h"
#include "platon/exact/point.h"
#include "platon/physics/map_geometry.h"

namespace platon {

/// A point on the surface of the solid.
struct Place {
  std::uint32_t part = 0;  ///< id of the map part
  Point position;          ///< subunits, in the frame of the part

  friend bool operator==(const Place&, const Place&) = default;
};

/// The position of `place` in the frame of `part`, found by unfolding neighbouring parts into the plane of `part`
/// through at most `maxWarps` warps. Of several unfoldings, returns the position nearest to `near`, rounded to the
/// lattice. Returns nothing when no chain of warps leads there. Visits up to (warps per part)^maxWarps parts.
std::optional<Point> unfold(const Geometry& geometry, const Place& place, std::uint32_t part, Point near, int maxWarps);

}  // namespace platon
