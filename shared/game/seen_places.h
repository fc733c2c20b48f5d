#pragma once

#include <cstdint>
#include <vector>

#include "platon/physics/map_geometry.h"
#include "platon/physics/unfold.h"

namespace platon {

/// The place itself, and where it lies in the frames of the parts within `distance` of it, unfolded over at most two
/// warps. A part that is reached both ways round a corner of the solid has a place for each. `distance` is in subunits,
/// below 2^20.
std::vector<Place> seenPlaces(const Geometry& geometry, const Place& place, std::int32_t distance);

}  // namespace platon
