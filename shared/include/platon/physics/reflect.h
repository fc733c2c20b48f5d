#pragma once

#include <cstdint>

#include "platon/exact/point.h"

namespace platon {

/// The velocity after a bounce off a wall: its component against `normal` is reversed and scaled by the restitution
/// `numerator / denominator`, the component along the wall is kept. That is v - (1 + n/d) * (v·N) / (N·N) * N, where
/// each coordinate is rounded once, to the nearest subunit per tick, halves away from zero. A restitution of 0 slides
/// along the wall, of 1 loses nothing. A velocity that does not lead against the normal (v·N >= 0) is returned
/// unchanged: so two contacts of one tick with the same wall reflect once.
///
/// `velocity` and `normal` are in one frame; only the direction of `normal` counts. For a contact, both are in the
/// frame of its segment if the velocity is rotate(entity.velocity(), -toHome), and the result is set by
/// setVelocity(result, toHome), with SegmentRef::toHome.
///
/// The result is no longer than `velocity`, but for the rounding: it is in the range of velocities when the length of
/// `velocity` is below 2^28 - 1. Throws std::invalid_argument unless `velocity` is in the range of velocities, `normal`
/// is not (0, 0) and in the range of normals (kNormalLimit), and 0 <= numerator <= denominator, 0 < denominator.
[[nodiscard]] Point reflect(Point velocity, Point normal, std::int32_t numerator, std::int32_t denominator);

}  // namespace platon
