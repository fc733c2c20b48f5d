#pragma once

#include <cstdint>
#include <optional>

#include "platon/exact/angle.h"
#include "platon/exact/point.h"
#include "platon/physics/map_geometry.h"

namespace platon {

/// Somewhere on the surface: a point in the frame of a map part, subunits.
struct Place {
  std::uint32_t part = 0;
  Point position;

  friend bool operator==(const Place&, const Place&) = default;
};

/// Where `place` lies in the frame of `part`, when the parts between are unfolded into its plane through at most
/// `maxWarps` warps; of several ways the one nearest to `near`. Nothing when there is none.
std::optional<Point> unfold(const Geometry& geometry, const Place& place, std::uint32_t part, Point near, int maxWarps);

}  // namespace platon
