#include "tests/exactness/reference/ideal_path.h"

#include <algorithm>
#include <stdexcept>

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

IdealPath::IdealPath(const ExactScene& scene, std::int64_t ticks, std::int64_t grown)
    : velocityX_(scene.velocity.x), velocityY_(scene.velocity.y) {
  obstacles_.reserve(scene.lines.size());
  for (const oracle::Segment& line : scene.lines) obstacles_.emplace_back(scene.shape, line, grown);
  at_ = {mpz_class(scene.start.x), mpz_class(scene.start.y), 1};
  compute(ticks);
}

IdealPath::Way IdealPath::freeWay() const { return {velocityX_, velocityY_, 1, {kFreeTicks * at_.d, 1}}; }

// The way to the end of the side to which the velocity leads. Its length is zero if the body is there.
IdealPath::Way IdealPath::wayAlong(const Side& side) const {
  const mpz_class speed = side.ahead(velocityX_, velocityY_);
  if (speed == 0) return {0, 0, 0, {0, 1}};
  const bool ahead = speed > 0;
  const mpz_class square = side.x * side.x + side.y * side.y;
  Way way{ahead ? mpz_class(-side.y) : side.y, ahead ? side.x : mpz_class(-side.x), mpq_class(abs(speed), square), {}};
  way.rate.canonicalize();
  const Place& end = ahead ? side.end : side.start;
  way.length = {at_.d * (end.x * way.x + end.y * way.y) - end.d * (at_.x * way.x + at_.y * way.y), end.d * square};
  return way;
}

// Clips the way against all sides (Cyrus-Beck).
std::optional<IdealPath::Hit> IdealPath::hitOf(std::size_t obstacle, const Way& way) const {
  std::optional<Hit> enter;
  std::optional<Quotient> leave;
  const std::vector<Side>& sides = obstacles_[obstacle].sides;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Side& side = sides[i];
    const mpz_class beyond = side.x * at_.x + side.y * at_.y - side.bound * at_.d;
    const mpz_class inwards = side.inwards(way.x, way.y);
    if (beyond >= 0) {
      if (inwards <= 0) return std::nullopt;
      const Hit hit{{beyond, inwards}, {obstacle, i}};
      const bool later = !enter || enter->way < hit.way || (side.alongLine && enter->way == hit.way);
      if (later) enter = hit;
    } else if (inwards < 0) {
      const Quotient time{-beyond, -inwards};
      if (!leave || time < *leave) leave = time;
    }
  }
  if (!enter) throw std::runtime_error("the body is inside an obstacle");
  if (!(enter->way < way.length) || (leave && !(enter->way < *leave))) return std::nullopt;
  return enter;
}

std::optional<IdealPath::Hit> IdealPath::firstHit(const Way& way) const {
  const double scale = at_.d.get_d();
  const double share = way.length.numerator.get_d() / way.length.denominator.get_d() / scale;
  const double x = at_.x.get_d() / scale;
  const double y = at_.y.get_d() / scale;
  const double byX = share * way.x.get_d();
  const double byY = share * way.y.get_d();
  std::optional<Hit> first;
  for (std::size_t i = 0; i < obstacles_.size(); ++i) {
    const PathObstacle& o = obstacles_[i];
    if (std::max(x, x + byX) < o.lowX || std::min(x, x + byX) > o.highX) continue;
    if (std::max(y, y + byY) < o.lowY || std::min(y, y + byY) > o.highY) continue;
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

// Whether the slide along one side leads into the other.
bool IdealPath::leadsInto(SideRef slide, SideRef other) const {
  const Way way = wayAlong(side(slide));
  return side(other).inwards(way.x, way.y) > 0;
}

void IdealPath::addLeg(Kind kind, const Way& way, SideRef along, SideRef against) {
  legs_.push_back({kind, now_, at_, {way.rate * way.x, way.rate * way.y}, along, against});
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

void IdealPath::compute(std::int64_t ticks) {
  std::optional<SideRef> contact;
  SideRef last;
  for (int turns = 0; now_ < ticks; ++turns) {
    if (turns > kMaxTurns) throw std::runtime_error("the ideal path turns for ever at one place");
    const Way way = contact ? wayAlong(side(*contact)) : freeWay();
    if (way.x == 0 && way.y == 0) return addLeg(Kind::kRest, way, *contact, last);
    const auto hit = firstHit(way);
    const Quotient length = hit ? hit->way : way.length;
    const bool moves = length.numerator != 0;
    if (moves) {
      addLeg(contact ? Kind::kSlide : Kind::kFree, way, contact.value_or(SideRef()), {});
      advance(way, length);
      turns = 0;
    }
    if (!hit) {
      if (contact) contact.reset();
      continue;
    }
    const SideRef blocking = blockingSide(hit->side);
    if (contact && !moves && leadsInto(blocking, *contact)) {
      return addLeg(Kind::kRest, {0, 0, 0, {0, 1}}, *contact, blocking);
    }
    last = contact.value_or(blocking);
    contact = blocking;
  }
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
