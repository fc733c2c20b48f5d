#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "platon/exact/fraction.h"
#include "shared/exact/lattice.h"
#include "shared/physics/ideal_geometry.h"
#include "shared/physics/step/stages.h"
#include "shared/physics/tolerances.h"

namespace platon {
namespace {

// Where the position shall go: near to the ideal place, on the outer side of what was hit. Of places equally near and
// equally far out, one ahead is taken.
struct Aim {
  PrecisePoint end;
  const LegHit* hit;  // may be null
};

constexpr auto kPlaces = latticeDisc<Tolerances::kFollow>();
constexpr auto kDetours = latticeDisc<Tolerances::kNudge>();
// A straight move to a place farther than 1.5 subunits from the ideal place is not good enough. Squared, in the units
// of PrecisePoint.
constexpr std::int64_t kSquaredNear = PrecisePoint::kOne * PrecisePoint::kOne * 9 / 4;

// In the units of PrecisePoint. Bounds: the place is less than 8 subunits away, so that the result is below 2^59.
std::int64_t squaredDistance(Point place, PrecisePoint ideal) {
  const PrecisePoint between = precise(place) - ideal;
  return between.x * between.x + between.y * between.y;
}

// By distance in whole subunits: the number of places that can be so near to the ideal place. It is less than 0.71
// subunits from the lattice point nearest to it, and (distance + 0.71)^2 < distance^2 + 1.5 distance + 0.51.
constexpr auto kPlacesWithin = [] {
  std::array<std::size_t, Tolerances::kFollow + 2> within{};
  for (std::size_t distance = 1; distance < within.size(); ++distance) {
    const auto reach = static_cast<std::int64_t>((2 * distance * distance + 3 * distance + 1) / 2);
    while (within[distance] < kPlaces.size() && squaredLength(kPlaces[within[distance]]) <= reach) ++within[distance];
  }
  return within;
}();

// The number of places that can be as near to the ideal place as this squared distance.
std::size_t placesWithin(std::int64_t squaredDistance) {
  std::size_t distance = 1;
  while (static_cast<std::int64_t>(distance * distance) * PrecisePoint::kOne * PrecisePoint::kOne < squaredDistance)
    ++distance;
  return kPlacesWithin[distance];
}

// A first sieve: whether the place is outside of the edge that stopped the leg.
bool mayStandAt(const StepState& step, const Aim& aim, Point place) {
  if (!aim.hit) return true;
  const Obstacle::HalfPlane& half = aim.hit->edge.half;
  return dot(half.normal, placementOf(step.instances, *aim.hit).at(place)) + half.offset >= 0;
}

// Of two places that are equally near: the one farther out, or farther ahead. So a mirrored scene moves in the same
// way.
bool isBetter(const StepState& step, const Aim& aim, Point offset, Point other) {
  const Point beyond = offset - other;
  const std::int64_t outwards = aim.hit ? dot(homeNormalOf(step.instances, *aim.hit), beyond) : 0;
  return outwards != 0 ? outwards > 0 : distanceTo({beyond, 0}, step.tick) > 0;
}

// Tries the places in order of their exact distance from the ideal place. The lattice point nearest to it may have been
// tried before.
std::optional<Point> nearestReachable(StepState& step, const Aim& aim, bool hasTriedNearest) {
  static_assert(kPlaces.front() == Point());
  const Point nearest = step.roundedAt(aim.end);
  std::array<bool, kPlaces.size()> tried{hasTriedNearest};
  for (;;) {
    std::optional<std::size_t> best;
    std::int64_t distance = 0;
    std::size_t considered = kPlaces.size();
    for (std::size_t i = 0; i < considered; ++i) {
      if (tried[i]) continue;
      const std::int64_t here = squaredDistance(nearest + kPlaces[i], aim.end);
      if (best && (here > distance || (here == distance && !isBetter(step, aim, kPlaces[i], kPlaces[*best])))) continue;
      if (!mayStandAt(step, aim, nearest + kPlaces[i])) continue;
      best = i;
      distance = here;
      considered = placesWithin(distance);
    }
    if (!best) return std::nullopt;
    tried[*best] = true;
    const Point place = nearest + kPlaces[*best];
    if (step.isReachable(place)) return place;
  }
}

// Where the straight way is blocked by an end that the ideal path just passes: by way of a place near the position, to
// one near the ideal place.
bool followByDetour(StepState& step, const Aim& aim) {
  const Point nearest = step.roundedAt(aim.end);
  const Point start = step.position();
  std::array<Point, kPlaces.size()> places;
  std::size_t count = 0;
  for (const Point offset : kPlaces) {
    const Point place = nearest + offset;
    const bool isNear = squaredDistance(place, aim.end) <= kSquaredNear;
    if (isNear && mayStandAt(step, aim, place) && step.allInRange(place) && step.mayBeAt(place))
      places[count++] = place;
  }
  for (const Point detour : std::span(kDetours).subspan(1)) {
    const Point over = start + detour;
    if (count == 0 || !step.allInRange(over) || !step.isFree(start, over)) continue;
    for (const Point place : std::span(places).first(count)) {
      if (!step.isFree(over, place)) continue;
      step.moveTo(over);
      // Rules::pierce is asked before each move.
      if (!step.isFree(over, place)) return false;
      step.moveTo(place);
      return true;
    }
  }
  return false;
}

// The work of `follow` where the lattice point nearest to the ideal place is not reachable, or is not the only nearest
// one.
bool followFarther(StepState& step, const Aim& aim, bool hasTriedNearest) {
  const auto place = nearestReachable(step, aim, hasTriedNearest);
  const bool isNear = place && squaredDistance(*place, aim.end) <= kSquaredNear;
  const Point start = step.position();
  if (!isNear && followByDetour(step, aim)) return true;
  if (!place || step.position() != start) return false;
  step.moveTo(*place);
  return true;
}

}  // namespace

bool follow(StepState& step, PrecisePoint end, const LegHit* hit) {
  const Aim aim{end, hit};
  const Point nearest = step.roundedAt(aim.end);
  const bool isNearestAlone = maxNorm(aim.end - precise(nearest)) < PrecisePoint::kOne / 2;
  const bool triesNearest = isNearestAlone && mayStandAt(step, aim, nearest);
  if (!triesNearest || !step.isReachable(nearest)) return followFarther(step, aim, triesNearest);
  step.moveTo(nearest);
  return true;
}

bool fallBack(StepState& step, PrecisePoint end) {
  const Point start = step.position();
  Point move = step.roundedAt(end) - start;
  const auto halve = [&] { move = {move.x / 2, move.y / 2}; };
  while (!step.allInRange(start + move)) halve();  // the start is in range
  if (const auto hit = step.collider.first(step.instances, start, start + move))
    move = scaleTruncated(move, hit->hit.time);
  while (move != Point() &&
         !(step.allInRange(start + move) && step.isFree(start, start + move) && step.mayBeAt(start + move)))
    halve();
  step.moveTo(start + move);
  return move != Point();
}

}  // namespace platon
