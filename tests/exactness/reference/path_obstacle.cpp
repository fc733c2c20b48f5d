#include "tests/exactness/reference/path_obstacle.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tests/exactness/oracle/sweep/sweep_oracle.h"

namespace platon::reference {
namespace {

using oracle::Vec;
using Side = PathObstacle::Side;

/// `distance` times the length of (x, y), rounded away from zero.
mpz_class timesLength(std::int64_t distance, const mpz_class& x, const mpz_class& y) {
  const mpz_class square = (x * x + y * y) * distance * distance;
  mpz_class root = sqrt(square);
  if (root * root != square) ++root;
  return distance < 0 ? mpz_class(-root) : root;
}

/// The common point of the boundaries of two sides. `after` is to the left of `before`.
Place corner(const Side& before, const Side& after) {
  Place at{before.bound * after.y - after.bound * before.y, before.x * after.bound - after.x * before.bound,
           before.x * after.y - before.y * after.x};
  const mpz_class common = gcd(gcd(at.x, at.y), at.d);
  at.x /= common;
  at.y /= common;
  at.d /= common;
  return at;
}

bool vanishes(const Side& side) {
  const Place& a = side.start;
  const Place& b = side.end;
  return side.ahead(b.x * a.d - a.x * b.d, b.y * a.d - a.y * b.d) <= 0;
}

}  // namespace

RationalVec Place::rational() const {
  RationalVec result{mpq_class(x, d), mpq_class(y, d)};
  result.x.canonicalize();
  result.y.canonicalize();
  return result;
}

PathObstacle::PathObstacle(const oracle::Polygon& shape, const oracle::Segment& line, std::int64_t grown) {
  const oracle::Polygon polygon = oracle::obstacleOf({shape, {}, {}, line});
  const std::size_t count = polygon.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec along = polygon[(i + 1) % count] - polygon[i];
    const mpz_class x(along.y);
    const mpz_class y(-along.x);
    sides.push_back({x,
                     y,
                     x * polygon[i].x + y * polygon[i].y + timesLength(grown, x, y),
                     {},
                     {},
                     oracle::cross(along, line.b - line.a) == 0,
                     (i + count - 1) % count,
                     (i + 1) % count});
  }
  for (Side& side : sides) side.start = corner(sides[side.before], side);
  for (Side& side : sides) side.end = sides[side.after].start;
  if (std::any_of(sides.begin(), sides.end(), vanishes)) throw std::runtime_error("a side of an obstacle vanishes");
  lowX = lowY = HUGE_VAL;
  highX = highY = -HUGE_VAL;
  for (const Side& side : sides) {
    const double x = side.start.x.get_d() / side.start.d.get_d();
    const double y = side.start.y.get_d() / side.start.d.get_d();
    lowX = std::min(lowX, x - 1);
    lowY = std::min(lowY, y - 1);
    highX = std::max(highX, x + 1);
    highY = std::max(highY, y + 1);
  }
}

}  // namespace platon::reference
