// The lattice position follows the ideal place. Every move is proved by the exact sweep (I1).
#include <array>
#include <span>

#include "platon/exact/integer.h"
#include "shared/exact/lattice.h"
#include "shared/physics/step/entity_step.h"
#include "shared/physics/turned_normal.h"

namespace platon {
namespace {

constexpr auto kPlaces = latticeDisc<Tolerances::kFollow>();
constexpr auto kDetours = latticeDisc<Tolerances::kNudge>();
// A straight move to a place farther than 1.5 subunits from the ideal place is not good enough. Squared, in the units
// of PrecisePoint.
constexpr std::int64_t kSquaredNear = PrecisePoint::kOne * PrecisePoint::kOne * 9 / 4;
constexpr std::int64_t kDetourReach = 2;  // squared, in subunits, if no straight move is possible

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

}  // namespace

bool EntityStep::follow(PrecisePoint end, const Leg& leg) {
  const Point nearest = roundedAt(end);
  const bool isNearestAlone = maxNorm(end - precise(nearest)) < PrecisePoint::kOne / 2;
  if (!isNearestAlone || !mayStandAt(nearest, leg) || !isReachable(nearest)) return followFarther(end, leg);
  moveTo(nearest);
  return true;
}

// The work of `follow` where the lattice point nearest to the ideal place is not reachable, or is not the only nearest
// one.
bool EntityStep::followFarther(PrecisePoint end, const Leg& leg) {
  const auto place = nearestReachable(end, leg);
  const bool isNear = place && squaredDistance(*place, end) <= kSquaredNear;
  if (!isNear && followByDetour(end, leg, place)) return true;
  if (place) moveTo(*place);
  return place.has_value();
}

// Tries the places in order of their exact distance from the ideal place.
std::optional<Point> EntityStep::nearestReachable(PrecisePoint end, const Leg& leg) {
  const Point nearest = roundedAt(end);
  std::array<bool, kPlaces.size()> tried{};
  for (;;) {
    std::optional<std::size_t> best;
    std::int64_t distance = 0;
    std::size_t considered = kPlaces.size();
    for (std::size_t i = 0; i < considered; ++i) {
      if (tried[i]) continue;
      const std::int64_t here = squaredDistance(nearest + kPlaces[i], end);
      if (best && (here > distance || (here == distance && !isBetter(kPlaces[i], kPlaces[*best], leg)))) continue;
      if (!mayStandAt(nearest + kPlaces[i], leg)) continue;
      best = i;
      distance = here;
      considered = placesWithin(distance);
    }
    if (!best) return std::nullopt;
    tried[*best] = true;
    const Point place = nearest + kPlaces[*best];
    if (isReachable(place)) return place;
  }
}

bool EntityStep::isReachable(Point place) {
  return place == position() || (allInRange(place) && collider_.isFreeInLeg(instances_, place));
}

// Of two places that are equally near: the one farther out, or farther ahead. So a mirrored scene moves in the same
// way.
bool EntityStep::isBetter(Point offset, Point other, const Leg& leg) const {
  const Point beyond = offset - other;
  const std::int64_t outwards = leg.hit ? dot(homeNormalOf(*leg.hit), beyond) : 0;
  return outwards != 0 ? outwards > 0 : distanceTo({beyond, 0}, tick_) > 0;
}

// A first sieve: whether the place is outside of the edge that stopped the leg.
bool EntityStep::mayStandAt(Point place, const Leg& leg) const {
  if (!leg.hit) return true;
  const Placement& placement = instances_.all()[leg.hit->placement];
  return dot(leg.hit->edge.half.normal, placement.at(place)) + leg.hit->edge.half.offset >= 0;
}

// Where the straight way is blocked by an end that the ideal path just passes: by way of a place near the position, to
// one that is nearer than `straight`.
bool EntityStep::followByDetour(PrecisePoint end, const Leg& leg, std::optional<Point> straight) {
  const Point nearest = roundedAt(end);
  const Point start = position();
  std::array<Point, kPlaces.size()> places;
  std::size_t count = 0;
  for (const Point offset : kPlaces) {
    const Point place = nearest + offset;
    const std::int64_t distance = squaredDistance(place, end);
    const bool isNear = straight ? distance <= kSquaredNear : squaredLength(offset) <= kDetourReach;
    if (isNear && mayStandAt(place, leg) && allInRange(place)) places[count++] = place;
  }
  for (const Point detour : std::span(kDetours).subspan(1)) {
    const Point over = start + detour;
    if (count == 0 || !allInRange(over) || !collider_.isFree(instances_, start, over)) continue;
    for (const Point place : std::span(places).first(count)) {
      if (!collider_.isFree(instances_, over, place)) continue;
      moveTo(over);
      moveTo(place);
      return true;
    }
  }
  return false;
}

// Moves as far as the lattice allows; the ideal place falls back to the position. Returns whether it moved.
bool EntityStep::fallBack(PrecisePoint end) {
  const Point start = position();
  const Point displacement = roundedAt(end) - start;
  Point move = displacement;
  if (const auto hit = collider_.first(instances_, start, start + displacement))
    move = scaleTruncated(displacement, hit->hit.time);
  while (move != Point() && !(allInRange(start + move) && collider_.isFree(instances_, start, start + move)))
    move = {move.x / 2, move.y / 2};
  moveTo(start + move);
  ideal_ = precise(position());
  return move != Point();
}

}  // namespace platon
