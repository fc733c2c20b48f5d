#include "shared/physics/step/free_flight.h"

#include "platon/exact/integer.h"
#include "platon/exact/precise_point.h"
#include "platon/physics/sweep.h"
#include "shared/physics/collider.h"
#include "shared/physics/tolerances.h"

namespace platon {
namespace {

// Whether a segment, of a wall or of a warp, is within Tolerances::kNear of the straight move.
bool isAnythingNear(const Placement& placement, Point displacement, Region& region, Region::Work& work) {
  Sweep sweep;
  sweep.start(*placement.shape, placement.position, displacement, Tolerances::kNear);
  region.cover(*placement.part, sweep.bounds().grown(Collider::kRegionMargin), work);
  for (std::size_t entry = 0; entry < region.segments().size(); ++entry) {
    if (region.mayOverlap(sweep, entry, *placement.shape)) return true;
  }
  return false;
}

}  // namespace

bool flyFreely(EntityState& state, Instances& instances, std::vector<Region>& regions, Region::Work& work) {
  constexpr std::int32_t kFar = kCoordinateLimit / 4;
  if (state.turn != 0 || !instances.isAlone() || instances.home().region >= regions.size()) return false;
  const PrecisePoint displacement = rotatePrecise(state.velocity, rotationOf(state.heading));
  if (maxNorm(displacement) <= Tolerances::kNoProgress || maxNorm(displacement) >= kFar * PrecisePoint::kOne ||
      maxNorm(state.position) >= kFar)
    return false;
  const PrecisePoint moved = displacement + PrecisePoint{state.remainder.x, state.remainder.y};
  const Point move = rounded(moved);
  const PrecisePoint remainder = moved - precise(move);
  // Of several nearest lattice points, `follow` chooses.
  if (maxNorm(remainder) >= PrecisePoint::kOne / 2) return false;
  Placement& home = instances.home();
  if (isAnythingNear(home, move, regions[home.region], work)) return false;
  instances.moveHomeTo(state.position + move);
  home.fresh = false;
  instances.storeHome(state);
  state.remainder = Point(static_cast<std::int32_t>(remainder.x), static_cast<std::int32_t>(remainder.y));
  return true;
}

}  // namespace platon
