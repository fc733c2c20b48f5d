#include "tests/exactness/reference/exact_body.h"

#include <algorithm>
#include <stdexcept>

#include "tests/exactness/oracle/sweep/sweep_oracle.h"

namespace platon::reference {
namespace {

using oracle::Vec;

// More than the rounding errors of double, less than the size of any scene.
constexpr double kMargin = 1;

RationalVec rational(Vec v) { return {mpq_class(v.x), mpq_class(v.y)}; }

mpq_class dot(const RationalVec& a, const RationalVec& b) { return a.x * b.x + a.y * b.y; }

bool mayHit(const oracle::Box& box, const RationalVec& from, const RationalVec& by) {
  const auto overlaps = [](double a, double step, std::int64_t low, std::int64_t high) {
    return std::min(a, a + step) - kMargin <= static_cast<double>(high) &&
           std::max(a, a + step) + kMargin >= static_cast<double>(low);
  };
  return overlaps(from.x.get_d(), by.x.get_d(), box.low.x, box.high.x) &&
         overlaps(from.y.get_d(), by.y.get_d(), box.low.y, box.high.y);
}

std::size_t bitsOf(const mpq_class& value) {
  return std::max(mpz_sizeinbase(value.get_num_mpz_t(), 2), mpz_sizeinbase(value.get_den_mpz_t(), 2));
}

}  // namespace

ExactBody::ExactBody(const ExactScene& scene) : velocity_(rational(scene.velocity)), position_(rational(scene.start)) {
  for (const oracle::Segment& line : scene.lines) {
    const oracle::Polygon polygon = oracle::obstacleOf({scene.shape, {}, {}, line});
    Obstacle obstacle{{}, oracle::boxOf(polygon)};
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec along = polygon[(i + 1) % polygon.size()] - polygon[i];
      const mpz_class x(along.y);
      const mpz_class y(-along.x);
      obstacle.sides.push_back({x, y, x * polygon[i].x + y * polygon[i].y, x * x + y * y, polygon[i],
                                polygon[(i + 1) % polygon.size()], oracle::cross(along, line.b - line.a) == 0,
                                (i + polygon.size() - 1) % polygon.size(), (i + 1) % polygon.size()});
    }
    obstacles_.push_back(std::move(obstacle));
  }
}

// Clips [0, 1) against all sides.
std::optional<ExactBody::Hit> ExactBody::hitOf(const Obstacle& obstacle, const RationalVec& from,
                                               const RationalVec& by) {
  Hit hit{0, &obstacle, nullptr};
  mpq_class exit = 1;
  for (const Side& side : obstacle.sides) {
    const mpq_class beyond = side.x * from.x + side.y * from.y - side.bound;
    const mpq_class speed = side.x * by.x + side.y * by.y;
    if (beyond >= 0) {
      if (beyond >= -speed) return std::nullopt;
      const mpq_class time = beyond / -speed;
      const bool tie = hit.side != nullptr && time == hit.time && side.alongLine;
      if (hit.side == nullptr || time > hit.time || tie) hit = {time, &obstacle, &side};
    } else if (speed > 0) {
      exit = std::min<mpq_class>(exit, -beyond / speed);
    }
  }
  if (hit.side == nullptr) throw std::runtime_error("the body starts inside an obstacle");
  return hit.time < exit ? std::optional(hit) : std::nullopt;
}

std::optional<ExactBody::Hit> ExactBody::firstHit(const RationalVec& by) const {
  std::optional<Hit> best;
  for (const Obstacle& obstacle : obstacles_) {
    if (!mayHit(obstacle.box, position_, by)) continue;
    const auto hit = hitOf(obstacle, position_, by);
    if (hit && (!best || hit->time < best->time)) best = hit;
  }
  return best;
}

void ExactBody::advance(const mpq_class& time, const RationalVec& by) {
  position_.x += time * by.x;
  position_.y += time * by.y;
  ++legs_;
  if (bits() > kMaxBits) throw std::runtime_error("the exact position needs more than 2^16 bits");
}

RationalVec ExactBody::along(const Side& side, const RationalVec& remaining) {
  const mpq_class inwards = (side.x * remaining.x + side.y * remaining.y) / side.squaredLength;
  return {remaining.x - inwards * side.x, remaining.y - inwards * side.y};
}

ExactBody::Slide ExactBody::slide(const Side& side, const RationalVec& remaining) const {
  const RationalVec whole = along(side, remaining);
  const mpq_class length = dot(whole, whole);
  if (length == 0) return {whole, 1};
  // The inside of an obstacle is to the left of its counter-clockwise sides.
  const bool forwards = whole.y * side.x - whole.x * side.y > 0;
  const RationalVec end = rational(forwards ? side.end : side.start);
  const mpq_class reach = dot({end.x - position_.x, end.y - position_.y}, whole) / length;
  const mpq_class fraction = std::clamp<mpq_class>(reach, 0, 1);
  return {{fraction * whole.x, fraction * whole.y}, fraction};
}

const ExactBody::Side* ExactBody::blockingSide(const Hit& hit, const RationalVec& remaining) const {
  if (slide(*hit.side, remaining).fraction != 0) return hit.side;
  const RationalVec whole = along(*hit.side, remaining);
  const bool forwards = whole.y * hit.side->x - whole.x * hit.side->y > 0;
  return &hit.obstacle->sides[forwards ? hit.side->after : hit.side->before];
}

void ExactBody::tick() {
  RationalVec remaining = velocity_;
  const Side* contact = nullptr;  // the side that the body slides along
  for (;;) {
    const Slide next = contact == nullptr ? Slide{remaining, 1} : slide(*contact, remaining);
    const auto hit = firstHit(next.displacement);
    const mpq_class time = hit ? hit->time : 1;
    advance(time, next.displacement);
    const mpq_class unused = 1 - time * next.fraction;
    remaining = {unused * remaining.x, unused * remaining.y};
    if (unused == 0 || (next.displacement.x == 0 && next.displacement.y == 0)) return;
    if (!hit) {
      contact = nullptr;
      continue;
    }
    const Side* blocking = blockingSide(*hit, remaining);
    if (contact != nullptr && dot({mpq_class(contact->x), mpq_class(contact->y)}, along(*blocking, remaining)) < 0 &&
        time == 0)
      return;
    contact = blocking;
  }
}

std::size_t ExactBody::bits() const { return std::max(bitsOf(position_.x), bitsOf(position_.y)); }

}  // namespace platon::reference
