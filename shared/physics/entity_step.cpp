#include "shared/physics/entity_step.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "platon/exact/integer.h"
#include "shared/physics/slide.h"

namespace platon {
namespace {

// An instance outlives its use a little, so that none flickers.
constexpr std::int32_t kDropMargin = 8;

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
  wanted_ = rest_ = Point();
  remainder_ = {state.remainder.x, state.remainder.y};
  isFree_ = true;
  stop_.reset();
  stopBefore_.reset();
  slidAlong_.reset();
  onwards_.reset();
  contacts_.clear();
  observe();
}

// What the entity wants stays as it is while it slides: a line takes only what leads into it, for as long as it
// touches.
void EntityStep::translate(Point velocity, Angle heading) {
  takeVelocity(velocity, heading);
  for (int legs = 0; legs < kMaxLegs; ++legs) {
    const Way way = nextWay();
    if (legs != 0 && way.whole == Point()) break;
    const Leg leg = admit(inRange(position() + way.part));
    const bool moves = leg.target != position();
    follow(leg, way);
    passHome();
    if (rest_ == Point() || !moves) break;
  }
  if (stop_ && instances_.dropUnreached(kDropMargin, collider_)) observe();
  keepRemainder();
}

// What rests does so exactly: a remainder alone moves nothing.
void EntityStep::takeVelocity(Point velocity, Angle heading) {
  if (velocity == Point()) return;
  const PrecisePoint exact = rotatePrecise(velocity, rotationOf(heading)) + remainder_;
  wanted_ = rest_ = rounded(exact);
  remainder_ = exact - precise(rest_);
}

// Where something was in the way, the exact place means nothing any more.
void EntityStep::keepRemainder() {
  const bool keeps =
      isFree_ && rest_ == Point() && std::max(std::abs(remainder_.x), std::abs(remainder_.y)) <= kRemainderLimit;
  state_->remainder =
      keeps ? Point(static_cast<std::int32_t>(remainder_.x), static_cast<std::int32_t>(remainder_.y)) : Point();
}

bool EntityStep::settle() {
  const Leg leg = admit(position());
  passHome();
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
    const auto met = collider_.firstWarp(instances_, {position(), leg.target, kInsertMargin}, leg.hit, shut_);
    if (!met) break;
    insertBehind(leg, *met);
  }
  if (instances_.all().size() != before) observe();
  return leg;
}

void EntityStep::insertBehind(Leg& leg, const LegHit& met) {
  const auto warp = static_cast<std::uint16_t>(instances_.all()[met.placement].part->warpOfSegment(met.line));
  if (instances_.fullBehind(met.placement)) {
    leg.end = End::kFull;
    leg.hit = met;
  } else if (instances_.insert(met.placement, warp, collider_)) {
    const Point target = inRange(leg.target);
    if (target == leg.target) {
      collider_.first(instances_, instances_.all().size() - 1, position(), target, leg.hit);
    } else {  // coordinates end earlier behind the warp
      leg.target = target;
      leg.hit = collider_.first(instances_, position(), target);
    }
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
  const Segment& line = placement.part->segments[met.line];
  return dot(perpendicular(line.b - line.a), placement.at(target) - placement.position) >= 0;
}

// Coordinates end at 2^29 in every part's frame: a displacement beyond is shortened until it stays inside.
Point EntityStep::inRange(Point target) const {
  while (target != position() && !allInRange(target)) target = position() + halved(target - position());
  return target;
}

bool EntityStep::allInRange(Point home) const {
  if (isFarFromEnds(home)) return true;
  return std::all_of(instances_.all().begin(), instances_.all().end(), [&](const Placement& placement) {
    const Point at = placement.at(home);
    return isCoordinate(at.x) && isCoordinate(at.y);
  });
}

// Whether neither home nor another instance could come near the end of coordinates on its way, whatever its frame:
// spares turning the way into theirs. A way of less than a quarter of the coordinates is less than half of them after.
bool EntityStep::isFarFromEnds(Point home) const {
  constexpr std::int32_t kNear = kCoordinateLimit / 4;
  if (maxNorm(home - position()) >= kNear) return false;
  return std::all_of(instances_.all().begin(), instances_.all().end(),
                     [](const Placement& placement) { return maxNorm(placement.position) < kNear; });
}

// Moves along the leg as far as it goes, and tells of what stopped it.
void EntityStep::follow(const Leg& leg, const Way& way) {
  if (leg.end == End::kReached) {
    const Point end = stop_ ? shortOfTurning(leg.target) : leg.target;
    const bool stays = end == position();
    moveAlong(way, end);
    if (stays) rest_ = Point();
    return;
  }
  const Point displacement = leg.target - position();
  const Point reached = position() + scaleTruncated(displacement, leg.hit->hit.time);
  if (leg.end == End::kStopped && tryToPass(leg, way, reached)) return;
  const Point end = stopBefore(*leg.hit, displacement);
  if (leg.end == End::kStopped && stop_ && isWedge(*leg.hit, end)) {
    restIn(*leg.hit, way);
    return;
  }
  moveAlong(way, end);
  if (leg.end == End::kFull) return;
  isFree_ = false;
  callContact(*leg.hit);
  stopBefore_ = std::exchange(stop_, leg.hit);
}

void EntityStep::moveAlong(const Way& way, Point end) {
  const Point start = position();
  moveTo(end);
  callPierced(start);
  rest_ = restAfter(way, end - start);
}

Point EntityStep::restAfter(const Way& way, Point moved) const {
  return rest_ - (way.slides ? scaleTruncated(rest_, shareOf(moved, way.whole)) : moved);
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
  const Segment& line = instances_.all()[hit.placement].part->segments[hit.line];
  return perpendicular(line.b - line.a);
}

Point EntityStep::homeNormalOf(const LegHit& hit) const {
  const Point normal = normalOf(hit);
  return hit.placement == 0 ? normal : turnedNormal(normal, instances_.all()[hit.placement].toHome);
}

// The centre may have crossed several parts; each passing turns the frame, and what is left of the displacement with
// it. Instances are dropped only afterwards: dropping first would let a fast mover escape the solid.
void EntityStep::passHome() {
  while (instances_.homeIsDue()) {
    if (instances_.mendDrift(collider_)) observe();
    const auto turn = instances_.passHome(remainder_);
    if (!turn) break;
    turnFrame(*turn);
    instances_.storeHome(*state_);
    state_->heading = state_->heading + *turn;
    observe();
  }
  if (!stop_ && instances_.dropUnreached(kDropMargin, collider_)) observe();
}

void EntityStep::turnFrame(Angle turn) {
  const Rotation direction = rotationOf(turn);
  const PrecisePoint rest = rotatePrecise(rest_, direction) + remainder_;
  rest_ = rest_ == Point() ? Point() : rounded(rest);
  remainder_ = rest - precise(rest_);
  wanted_ = rotate(wanted_, direction);
  if (onwards_) onwards_ = Way{rotate(onwards_->part, direction), rotate(onwards_->whole, direction), onwards_->slides};
  stop_.reset();  // indices were of the old order
  stopBefore_.reset();
  slidAlong_.reset();
}

void EntityStep::moveTo(Point position) {
  if (position == this->position()) return;
  instances_.moveHomeTo(position);
  state_->position = position;
  stop_.reset();
  stopBefore_.reset();
  observe();
}

void EntityStep::observe() {
  if (observer_ == nullptr) return;
  views_.clear();
  instances_.appendViews(views_);
  observer_->leg(entity_->index(), views_);
}

}  // namespace platon
