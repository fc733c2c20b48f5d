#pragma once

#include <cstddef>
#include <cstdint>

#include "platon/exact/angle.h"
#include "platon/exact/point.h"
#include "platon/physics/convex.h"
#include "platon/physics/map_geometry.h"

namespace platon {

/// One instance of an entity while it is being moved.
struct Placement {
  static constexpr std::size_t kNone = ~std::size_t{0};

  const MapGeometry* part = nullptr;
  const Convex* shape = nullptr;  ///< turned by `angle`
  Angle angle;
  Rotation fromHome;  ///< turns the home part's frame into this part's
  Rotation toHome;    ///< and back
  Point position;
  Point homeAnchor;
  Point anchor;
  std::size_t parent = kNone;     ///< index among the placements; none for home and when placed by hand
  std::uint16_t warp = 0;         ///< of the parent's part, leads here
  std::uint16_t reverseWarp = 0;  ///< of this part, leads to the parent
  std::uint16_t id = 0;
  bool fresh = false;      ///< met no line yet
  std::size_t region = 0;  ///< index among the entity's regions

  /// Where this instance is when home is at `home`.
  Point at(Point home) const {
    const Point moved = home - homeAnchor;
    return anchor + (fromHome == Rotation::none() ? moved : rotate(moved, fromHome));
  }
};

}  // namespace platon
