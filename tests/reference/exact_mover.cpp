#include "tests/reference/exact_mover.h"

#include <algorithm>
#include <stdexcept>

#include "tests/oracle/sweep_oracle.h"

namespace platon::reference {
namespace {

using oracle::Vec;

// Far more than a double is off by, far less than any scene.
constexpr double kMargin = 1;

RationalVec rational(Vec v) { return {mpq_class(v.x), mpq_class(v.y)}; }

mpq_class dot(const RationalVec& a, const RationalVec& b) { return a.x * b.x + a.y * b.y; }

bool mayMeet(const oracle::Box& box, const RationalVec& from, const RationalVec& by) {
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

ExactMover::ExactMover(const ExactScene& scene)
    : velocity_(rational(scene.velocity)), position_(rational(scene.start)) {
  for (const oracle::Segment& line : scene.lines) {
    const oracle::Polygon polygon = oracle::forbiddenPolygon({scene.shape, {}, {}, line});
    Obstacle obstacle{{}, oracle::boxOf(polygon)};
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec along = polygon[(i + 1) % polygon.size()] - polygon[i];
      const mpz_class x(along.y);
      const mpz_class y(-along.x);
      obstacle.sides.push_back({x, y, x * polygon[i].x + y * polygon[i].y, x * x + y * y,
                               oracle::cross(along, line.b - line.a) == 0});
    }
    obstacles_.push_back(std::move(obstacle));
  }
}

// The part of [0, 1) inside all sides.
std::optional<ExactMover::Hit> ExactMover::meet(const Obstacle& obstacle, const RationalVec& from,
                                                const RationalVec& by) {
  Hit hit{0, nullptr};
  mpq_class exit = 1;
  for (const Side& side : obstacle.sides) {
    const mpq_class beyond = side.x * from.x + side.y * from.y - side.bound;
    const mpq_class speed = side.x * by.x + side.y * by.y;
    if (beyond >= 0) {
      if (beyond >= -speed) return std::nullopt;
      const mpq_class time = beyond / -speed;
      const bool tie = hit.side != nullptr && time == hit.time && side.alongLine;
      if (hit.side == nullptr || time > hit.time || tie) hit = {time, &side};
    } else if (speed > 0) {
      exit = std::min<mpq_class>(exit, -beyond / speed);
    }
  }
  if (hit.side == nullptr) throw std::runtime_error("the mover starts inside an obstacle");
  return hit.time < exit ? std::optional(hit) : std::nullopt;
}

std::optional<ExactMover::Hit> ExactMover::first(const RationalVec& by) const {
  std::optional<Hit> best;
  for (const Obstacle& obstacle : obstacles_) {
    if (!mayMeet(obstacle.box, position_, by)) continue;
    const auto hit = meet(obstacle, position_, by);
    if (hit && (!best || hit->time < best->time)) best = hit;
  }
  return best;
}

void ExactMover::advance(const mpq_class& time, const RationalVec& by) {
  position_.x += time * by.x;
  position_.y += time * by.y;
  ++legs_;
  if (bits() > kMostBits) throw std::runtime_error("the exact position has outgrown its bits");
}

void ExactMover::tick() {
  RationalVec rest = velocity_;
  std::vector<const Side*> here;   // edges that have stopped the mover where it is
  while (const auto hit = first(rest)) {
    advance(hit->time, rest);
    if (hit->time != 0) here.clear();
    if (std::find(here.begin(), here.end(), hit->side) != here.end()) return;
    here.push_back(hit->side);
    const mpq_class left = 1 - hit->time;
    const mpq_class inwards = (hit->side->x * rest.x + hit->side->y * rest.y) / hit->side->squaredLength;
    rest = {left * (rest.x - inwards * hit->side->x), left * (rest.y - inwards * hit->side->y)};
    if (dot(rest, velocity_) <= 0) return;
  }
  advance(1, rest);
}

std::size_t ExactMover::bits() const { return std::max(bitsOf(position_.x), bitsOf(position_.y)); }

}  // namespace platon::reference
