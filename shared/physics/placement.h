#pragma once

#include <cstddef>
#include <cstdint>

#include "platon/exact/angle.h"
#include "platon/exact/point.h"
#include "platon/physics/convex.h"
#include "platon/physics/map_geometry.h"

namespace platon {

/// The working copy of one instance of an entity during a step. See InstanceState for the anchors.
struct Placement {
  static constexpr std::size_t kNone = ~std::size_t{0};

  const MapGeometry* part = nullptr;
  const Convex* shape = nullptr;  ///< the entity's shape rotated by `angle`
  Angle angle;
  Rotation fromHome;  ///< from the frame of the home part to the frame of this part
  Rotation toHome;    ///< from the frame of this part to the frame of the home part
  Point position;
  Point homeAnchor;
  Point anchor;
  std::size_t parent = kNone;     ///< index among the placements; kNone when there is no parent
  std::uint16_t warp = 0;         ///< index, in the parent's part, of the warp to this part
  std::uint16_t reverseWarp = 0;  ///< index, in this part, of the warp to the parent's part
  std::uint16_t id = 0;
  bool fresh = false;      ///< see InstanceState; read at the start of a step only
  std::size_t region = 0;  ///< index among the entity's regions

  /// The position of this instance when the home instance is at `home`.
  Point at(Point home) const {
    const Point moved = home - homeAnchor;
    return anchor + (fromHome == Rotation::none() ? moved : rotate(moved, fromHome));
  }
};

}  // namespace platon
