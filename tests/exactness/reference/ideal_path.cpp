#include "tests/exactness/reference/ideal_path.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace platon::reference {
namespace {

using Side = PathObstacle::Side;

/// A free way is examined in parts of this many ticks, so that few obstacles are near each of them.
constexpr int kFreeTicks = 32;

/// More than this many turns at one place is an error of this class.
constexpr int kMaxTurns = 1000;

void shorten(Place& at) {
  const mpz_class common = gcd(gcd(at.x, at.y), at.d);
  if (common == 1) return;
  at.x /= common;
  at.y /= common;
  at.d /= common;
}

void roundTime(mpq_class& time) {
  if (mpz_sizeinbase(time.get_den_mpz_t(), 2) <= IdealPath::kMaxTimeBits) return;
  mpz_class scaled = (time.get_num() << (IdealPath::kTimeBits + 1)) / time.get_den() + 1;
  scaled >>= 1;
  time = mpq_class(scaled, mpz_class(1) << IdealPath::kTimeBits);
  time.canonicalize();
}

}  // namespace

IdealPath::IdealPath(const ExactScene& scene, std::int64_t ticks, std::int64_t unit)
    : course_(std::make_shared<Course>(scene)),
      velocityX_(scene.velocity.x),
      velocityY_(scene.velocity.y),
      ticks_(ticks),
      restSpeed_(kRestSpeed * unit),
      at_{mpz_class(scene.start.x), mpz_class(scene.start.y), 1} {
  compute();
}

IdealPath IdealPath::from(const Place& start, const mpq_class& begin,
                          const std::function<bool(const Leg&)>& stops) const {
  IdealPath path(*this);
  path.legs_.clear();
  path.at_ = start;
  path.now_ = begin;
  path.contact_.reset();
  path.stops_ = stops;
  path.compute();
  return path;
}

bool IdealPath::isFree(const Place& place) const {
  const auto isInside = [&](const Side& side) { return side.x * place.x + side.y * place.y < side.bound * place.d; };
  const std::vector<std::size_t> near = course_->near(Reach(place, 0, 0));
  return std::none_of(near.begin(), near.end(), [&](std::size_t obstacle) {
    const std::vector<Side>& sides = (*course_)[obstacle].sides;
    return std::all_of(sides.begin(), sides.end(), isInside);
  });
}

IdealPath::Way IdealPath::freeWay() const { return {velocityX_, velocityY_, 1, {kFreeTicks * at_.d, 1}}; }

// The way to the end of the side to which the velocity leads. Its length is zero if the body is there.
IdealPath::Way IdealPath::wayAlong(const Side& side) const {
  const mpz_class speed = side.ahead(velocityX_, velocityY_);
  if (speed == 0) return {0, 0, 0, {0, 1}};
  const bool ahead = speed > 0;
  const mpz_class square = side.x * side.x + side.y * side.y;
  if (std::max(abs(speed * side.x), abs(speed * side.y)) < restSpeed_ * square) return {0, 0, 0, {0, 1}};
  Way way{ahead ? mpz_class(-side.y) : side.y, ahead ? side.x : mpz_class(-side.x), mpq_class(abs(speed), square), {}};
  way.rate.canonicalize();
  const oracle::Vec end = ahead ? side.end : side.start;
  way.length = {(end.x * at_.d - at_.x) * way.x + (end.y * at_.d - at_.y) * way.y, square};
  return way;
}

// Clips the way against all sides (Cyrus-Beck).
std::optional<IdealPath::Hit> IdealPath::hitOf(std::size_t obstacle, const Way& way) const {
  std::optional<Hit> enter;
  std::optional<Quotient> leave;
  const std::vector<Side>& sides = (*course_)[obstacle].sides;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Side& side = sides[i];
    const mpz_class beyond = side.x * at_.x + side.y * at_.y - side.bound * at_.d;
    const mpz_class inwards = side.inwards(way.x, way.y);
    if (beyond >= 0) {
      if (inwards <= 0) return std::nullopt;
      const Hit hit{{beyond, inwards}, {obstacle, i}};
      const auto takesPrecedence = [&] {
        const Side& other = sides[enter->side.side];
        if (side.alongLine != other.alongLine) return side.alongLine;
        const mpz_class steep = other.inwards(way.x, way.y);
        return inwards * inwards * (other.x * other.x + other.y * other.y) <
               steep * steep * (side.x * side.x + side.y * side.y);
      };
      if (!enter || enter->way < hit.way || (enter->way == hit.way && takesPrecedence())) enter = hit;
    } else if (inwards < 0) {
      const Quotient time{-beyond, -inwards};
      if (!leave || time < *leave) leave = time;
    }
  }
  if (!enter) throw std::runtime_error("the body starts inside an obstacle");
  if (!(enter->way < way.length) || (leave && !(enter->way < *leave))) return std::nullopt;
  return enter;
}

std::optional<IdealPath::Hit> IdealPath::firstHit(const Way& way) const {
  const double share = quotient(way.length.numerator, way.length.denominator * at_.d);
  const Reach reach(at_, share * way.x.get_d(), share * way.y.get_d());
  std::optional<Hit> first;
  for (const std::size_t i : course_->near(reach)) {
    const auto hit = hitOf(i, way);
    if (hit && (!first || hit->way < first->way)) first = hit;
  }
  return first;
}

// The side that blocks the body: the side hit, or the adjacent one if the body is already at the end of that side.
IdealPath::SideRef IdealPath::blockingSide(SideRef hit) const {
  const Way way = wayAlong(side(hit));
  if ((way.x == 0 && way.y == 0) || way.length.numerator > 0) return hit;
  const bool ahead = side(hit).ahead(velocityX_, velocityY_) > 0;
  return {hit.obstacle, ahead ? side(hit).after : side(hit).before};
}

// Whether the way along a side leads into an obstacle that the body touches.
bool IdealPath::leadsInto(SideRef slide, std::size_t obstacle) const {
  const auto hit = hitOf(obstacle, wayAlong(side(slide)));
  return hit && hit->way.numerator == 0;
}

void IdealPath::addLeg(Kind kind, const Way& way, SideRef along) {
  legs_.push_back({kind, now_, at_, {way.rate * way.x, way.rate * way.y}, along, {}});
}

bool IdealPath::addRest(SideRef against) {
  legs_.push_back({Kind::kRest, now_, at_, {}, *contact_, against});
  if (stops_) stops_(legs_.back());
  return false;
}

void IdealPath::advance(const Way& way, const Quotient& length) {
  mpq_class time(length.numerator, length.denominator * at_.d);
  time.canonicalize();
  now_ += time / way.rate;
  roundTime(now_);
  at_ = {at_.x * length.denominator + length.numerator * way.x, at_.y * length.denominator + length.numerator * way.y,
         at_.d * length.denominator};
  shorten(at_);
}

void IdealPath::compute() {
  while (now_ < ticks_ && turn()) {
    if (++turns_ > kMaxTurns) throw std::logic_error("the ideal path turns for ever at one place");
  }
}

// Moves to the next contact or to the end of the way, or only turns at a contact. Returns false if the path ends.
bool IdealPath::turn() {
  const Way way = contact_ ? wayAlong(side(*contact_)) : freeWay();
  if (way.x == 0 && way.y == 0) return addRest(last_);
  const auto hit = firstHit(way);
  const bool moves = !hit || hit->way.numerator != 0;
  if (moves) {
    addLeg(contact_ ? Kind::kSlide : Kind::kFree, way, contact_.value_or(SideRef()));
    if (stops_ && stops_(legs_.back())) return false;
    advance(way, hit ? hit->way : way.length);
    turns_ = 0;
  }
  if (!hit) {
    contact_.reset();
    return true;
  }
  const SideRef blocking = blockingSide(hit->side);
  if (contact_ && !moves && leadsInto(blocking, contact_->obstacle)) return addRest(blocking);
  last_ = contact_.value_or(blocking);
  contact_ = blocking;
  return true;
}

const IdealPath::Leg& IdealPath::legAt(const mpq_class& tick) const {
  const auto after = std::upper_bound(legs_.begin(), legs_.end(), tick,
                                      [](const mpq_class& time, const Leg& leg) { return time < leg.begin; });
  return *std::prev(after);
}

RationalVec IdealPath::positionAt(std::int64_t tick) const {
  const mpq_class time(tick);
  const Leg& leg = legAt(time);
  const RationalVec start = leg.start.rational();
  const mpq_class passed = time - leg.begin;
  return {start.x + passed * leg.velocity.x, start.y + passed * leg.velocity.y};
}

bool IdealPath::touchesBetween(std::int64_t first, std::int64_t last) const {
  for (const Leg* leg = &legAt(mpq_class(first)); leg != legs_.data() + legs_.size() && leg->begin <= last; ++leg) {
    if (leg->kind != Kind::kFree) return true;
  }
  return false;
}

}  // namespace platon::reference
