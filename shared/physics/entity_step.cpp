#include "shared/physics/entity_step.h"

#include <algorithm>
#include <array>

#include "shared/exact/integer.h"
#include "shared/physics/slide.h"

namespace platon {
namespace {

// Margins of DESIGN section 2: an instance comes into being before its part is reached, and outlives its use a little,
// so that none flickers.
constexpr std::int32_t kInsertMargin = 4;
constexpr std::int32_t kDropMargin = 8;

// A bump lower than this is passed over (I3): lines meant to join may be off by a rounding at each end.
constexpr std::int32_t kNudge = 3;
constexpr std::size_t kNudges = 28;

// Sideways steps, nearest first.
constexpr auto kNudgeOffsets = [] {
  std::array<Point, kNudges> offsets{};
  std::size_t count = 0;
  for (std::int64_t squared = 1; squared <= kNudge * kNudge; ++squared) {
    for (int y = -kNudge; y <= kNudge; ++y) {
      for (int x = -kNudge; x <= kNudge; ++x) {
        if (squaredLength(Point(x, y)) == squared) offsets[count++] = Point(x, y);
      }
    }
  }
  return offsets;
}();
static_assert(kNudgeOffsets.back() != Point());

constexpr Point scaleTruncated(Point displacement, Fraction time) {
  return {platon::scaleTruncated(displacement.x, time), platon::scaleTruncated(displacement.y, time)};
}

Point halved(Point displacement) { return {displacement.x / 2, displacement.y / 2}; }

}  // namespace

void EntityStep::begin(Entity entity, EntityState& state, std::span<const InstanceState> further,
                       const Setting& setting) {
  entity_.emplace(entity);
  state_ = &state;
  rules_ = &setting.rules;
  observer_ = setting.observer;
  instances_.load(setting.geometry, setting.shapes, setting.base, state, further);
  collider_.begin(setting.rules, entity, setting.regions);
  observe();
}

void EntityStep::translate(Point displacement) {
  wanted_ = displacement;
  stops_.clear();
  Point rest = displacement;
  for (int legs = 0; legs < kMostLegs; ++legs) {
    const Point start = position();
    const Point goal = start + rest;
    const Leg leg = admit(inRange(goal));
    const Point left = follow(leg);
    rest = leg.end == End::kReached ? goal - position() : left;
    passHome(rest);
    if (rest == Point() || leg.target == start) break;
  }
}

bool EntityStep::settle() {
  const Leg leg = admit(position());
  Point rest;
  passHome(rest);
  return leg.end == End::kReached && shut_.empty();
}

void EntityStep::finish(std::vector<InstanceState>& further) {
  callOver();
  store(further);
}

// Instances have to be there before the leg begins: then their shape is still outside their part, and free.
EntityStep::Leg EntityStep::admit(Point target) {
  shut_.clear();
  const std::size_t before = instances_.all().size();
  Leg leg{target, End::kReached, collider_.first(instances_, position(), target)};
  if (leg.hit) leg.end = End::kStopped;
  while (leg.end == End::kReached || leg.end == End::kStopped) {
    const auto met = collider_.firstWarp(instances_, {position(), target, kInsertMargin}, leg.hit, shut_);
    if (!met) break;
    insertBehind(leg, *met);
  }
  if (instances_.all().size() != before) observe();
  return leg;
}

void EntityStep::insertBehind(Leg& leg, const LegHit& met) {
  const auto warp = static_cast<std::uint16_t>(instances_.all()[met.placement].part->warpOfLine(met.line));
  if (instances_.fullBehind(met.placement)) {
    leg.end = End::kFull;
    leg.hit = met;
  } else if (instances_.insert(met.placement, warp, collider_)) {
    collider_.first(instances_, instances_.all().size() - 1, position(), leg.target, leg.hit);
    leg.end = leg.hit ? End::kStopped : End::kReached;
  } else if (leadsAway(met, leg.target)) {
    shut_.push_back({met.placement, warp});
  } else {
    leg.end = End::kRefused;
    leg.hit = met;
  }
}

// Away from the warp line, or along it: nothing is missed without the instance behind it.
bool EntityStep::leadsAway(const LegHit& met, Point target) const {
  const Placement& placement = instances_.all()[met.placement];
  const Segment& line = placement.part->lines[met.line];
  return dot(perpendicular(line.b - line.a), placement.at(target) - placement.position) >= 0;
}

// Coordinates end at 2^29 in every part's frame: a displacement beyond is shortened until it stays inside.
Point EntityStep::inRange(Point target) const {
  while (!allInRange(target)) target = position() + halved(target - position());
  return target;
}

bool EntityStep::allInRange(Point home) const {
  return std::all_of(instances_.all().begin(), instances_.all().end(), [&](const Placement& placement) {
    const Point at = placement.at(home);
    return isCoordinate(at.x) && isCoordinate(at.y);
  });
}

// Moves along the leg as far as it goes, and tells of what stopped it. Returns what is left of the displacement.
Point EntityStep::follow(const Leg& leg) {
  const Point start = position();
  if (leg.end == End::kReached) {
    moveTo(leg.target);
    callPierced(start);
    return {};
  }
  const Point displacement = leg.target - start;
  if (leg.end == End::kStopped) {
    const Point reached = start + scaleTruncated(displacement, leg.hit->hit.time);
    if (const auto nudged = nudge(*leg.hit, leg.target, reached)) {
      moveTo(*nudged);
      callPierced(start);
      return leg.target - reached;
    }
  }
  moveTo(stopBefore(*leg.hit, displacement));
  callPierced(start);
  const Point left = leg.target - position();
  if (leg.end == End::kFull) return left;
  callContact(*leg.hit);
  stops_.push_back(homeNormalOf(*leg.hit));
  return slide(*leg.hit, left);
}

// What is left of a displacement slides along the line that stopped it. Between two lines, which each lead into the
// other, nothing is left; nor when it would turn back, which would rattle in a corner for ever.
Point EntityStep::slide(const LegHit& hit, Point left) const {
  const Point slid = outOf(hit, slideAlong(left, stops_.back()));
  const bool intoAnother = std::any_of(stops_.begin(), stops_.end() - 1, [&](Point normal) { return dot(slid, normal) < 0; });
  return intoAnother || leadsBack(left) ? Point() : slid;
}

// The unrounded direction decides: a slope that is nearly level to what the entity wants leads on by so little that
// rounding it outwards seems to lead back.
bool EntityStep::leadsBack(Point left) const {
  const Point tangent = perpendicular(stops_.back());
  const std::int64_t along = dot(left, tangent);
  const std::int64_t wanted = dot(wanted_, tangent);
  return !((along > 0 && wanted > 0) || (along < 0 && wanted < 0));
}

// The instance that met the line moves by its own rounding of the displacement, which could lead into the line again: a
// few subunits outwards prevent that. Bounds: normal < 2^30, displacement < 2^31.
Point EntityStep::outOf(const LegHit& hit, Point slid) const {
  const Placement& placement = instances_.all()[hit.placement];
  const Point outwards = dominantStep(stops_.back());
  for (int steps = 0; steps < kNudge && slid != Point(); ++steps, slid += outwards) {
    if (dot(normalOf(hit), placement.at(position() + slid) - placement.position) >= 0) break;
  }
  return slid;
}

// I3: an end of a line that a step of a few subunits to the side clears is passed, not hit. The way must lead on from
// there, so that nothing at rest is ever nudged to and fro.
std::optional<Point> EntityStep::nudge(const LegHit& hit, Point target, Point reached) {
  if (hit.hit.side != Hit::Side::kLineEnd || !grazes(hit, target, reached)) return std::nullopt;
  for (const Point offset : kNudgeOffsets) {
    const Point from = reached + offset;
    const Point to = target + offset;
    if (dot(to - position(), wanted_) <= 0 || !allInRange(to)) continue;
    if (leadsOn(hit, from, to) && collider_.isFree(instances_, position(), from)) return from;
  }
  return std::nullopt;
}

// Whether the end of the line passes within kNudge of either flank of the shape: else no nudge can clear it.
// Bounds: side < 2^30, differences < 2^31, so that products are < 2^62.
bool EntityStep::grazes(const LegHit& hit, Point target, Point reached) const {
  const Placement& placement = instances_.all()[hit.placement];
  const Point from = placement.at(reached);
  const Point side = perpendicular(placement.at(target) - from);
  std::int64_t low = dot(side, placement.shape->vertices()[0]);
  std::int64_t high = low;
  for (const Point vertex : placement.shape->vertices()) {
    low = std::min(low, dot(side, vertex));
    high = std::max(high, dot(side, vertex));
  }
  const std::int64_t end = dot(side, hit.hit.feature - from);
  const int128 depth = std::min(end - low, high - end);
  return depth <= 0 || depth * depth <= int128{kNudge * kNudge} * squaredLength(side);
}

bool EntityStep::leadsOn(const LegHit& hit, Point from, Point to) {
  const Placement& placement = instances_.all()[hit.placement];
  const auto again = collider_.against(placement, placement.at(from), placement.at(to), placement.part->lines[hit.line]);
  if (again && again->side != Hit::Side::kLine) return false;
  const auto next = collider_.first(instances_, from, to);
  return !next || squaredLength(scaleTruncated(to - from, next->hit.time)) > squaredLength(Point(kNudge, kNudge));
}

// A truncated contact point is only a candidate: it can lie inside the obstacle by up to a subunit. At most two steps
// along the dominant axis of the normal lead out of the entered edge; where other lines or instances are in the way of
// that too, shorter moves are tried, and at last none, which is always free.
Point EntityStep::stopBefore(const LegHit& hit, Point displacement) {
  const Point outwards = dominantStep(homeNormalOf(hit));
  Point move = scaleTruncated(displacement, hit.hit.time);
  while (move != Point()) {
    if (const auto free = firstFree(position() + move, outwards, displacement)) return *free;
    move = halved(move);
  }
  return position();
}

std::optional<Point> EntityStep::firstFree(Point candidate, Point outwards, Point displacement) {
  for (int steps = 0; steps <= 2; ++steps, candidate += outwards) {
    if (dot(candidate - position(), displacement) <= 0) continue;
    if (allInRange(candidate) && collider_.isFree(instances_, position(), candidate)) return candidate;
  }
  return std::nullopt;
}

// Of a warp line that the grown shape overlaps already: into its part.
Point EntityStep::normalOf(const LegHit& hit) const {
  if (hit.hit.side != Hit::Side::kInside) return hit.hit.normal;
  const Segment& line = instances_.all()[hit.placement].part->lines[hit.line];
  return perpendicular(line.b - line.a);
}

Point EntityStep::homeNormalOf(const LegHit& hit) const {
  const Angle toHome = instances_.home().angle - instances_.all()[hit.placement].angle;
  return hit.placement == 0 ? normalOf(hit) : turnedNormal(normalOf(hit), toHome);
}

// The centre may have crossed several parts; each passing turns the frame, and what is left of the displacement with
// it. Instances are dropped only afterwards: dropping first would let a fast mover escape the solid.
void EntityStep::passHome(Point& rest) {
  while (instances_.homeIsDue()) {
    if (instances_.mendDrift(collider_)) observe();
    const auto turn = instances_.passHome();
    if (!turn) break;
    rest = rotate(rest, *turn);
    wanted_ = rotate(wanted_, *turn);
    stops_.clear();   // they were in the old frame
    instances_.storeHome(*state_);
    state_->heading = state_->heading + *turn;
    observe();
  }
  if (instances_.dropUnreached(kDropMargin)) observe();
}

void EntityStep::moveTo(Point position) {
  const bool moved = position != this->position();
  instances_.moveHomeTo(position);
  state_->position = position;
  if (!moved) return;
  stops_.clear();
  observe();
}

void EntityStep::observe() {
  if (observer_ == nullptr) return;
  views_.clear();
  instances_.appendViews(views_);
  observer_->leg(entity_->index(), views_);
}

}  // namespace platon
