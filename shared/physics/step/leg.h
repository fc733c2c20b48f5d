#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "platon/exact/fraction.h"
#include "platon/exact/point.h"
#include "platon/exact/precise_point.h"
#include "shared/physics/collider.h"
#include "shared/physics/step/mover.h"

namespace platon {

/// One straight move of the ideal place, and what ends it.
struct Leg {
  enum class End : std::uint8_t {
    kReached,
    kStopped,  ///< hit a blocking segment
    kRefused,  ///< an instance that the leg needs cannot be placed
    kFull,     ///< the limit of instances is reached
  };
  PrecisePoint displacement{};  ///< of the ideal place, if nothing is hit
  Point target{};               ///< of the position, if nothing is hit
  Fraction share{1, 1};         ///< of the planned displacement: less if that leads out of the coordinates
  End end = End::kReached;
  std::optional<LegHit> hit{};  ///< the blocking segment or warp segment that ends it

  bool isStopped() const { return hit && end != End::kFull; }
};

/// Finds where a leg by leg.displacement ends that begins at the ideal place `from`, and inserts the instances that it
/// needs: before the leg, while their shape is still outside of their part and therefore free. `slidesOn` is the
/// contact along which the leg slides and whose obstacle it cannot enter, or null. `refused`
/// receives the warps behind which an instance cannot be placed, but which the leg leads away from; what it held before
/// is discarded.
void prepareLeg(Leg& leg, Mover& mover, PrecisePoint from, const LegHit* slidesOn,
                std::vector<Collider::WarpRef>& refused);
/// The same for a leg that slides on along a contact of the home instance, which the displacement `wanted` has met at
/// once. Returns false, and inserts nothing, if it would have met another segment instead.
bool prepareSlide(Leg& leg, Mover& mover, PrecisePoint from, const LegHit& contact, PrecisePoint wanted,
                  std::vector<Collider::WarpRef>& refused);

}  // namespace platon
