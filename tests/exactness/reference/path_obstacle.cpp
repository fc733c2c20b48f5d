#include "tests/exactness/reference/path_obstacle.h"

#include "tests/exactness/oracle/sweep/sweep_oracle.h"

namespace platon::reference {

using oracle::Vec;

RationalVec Place::rational() const {
  RationalVec result{mpq_class(x, d), mpq_class(y, d)};
  result.x.canonicalize();
  result.y.canonicalize();
  return result;
}

PathObstacle::PathObstacle(const oracle::Polygon& shape, const oracle::Segment& line) {
  const oracle::Polygon polygon = oracle::obstacleOf({shape, {}, {}, line});
  box = oracle::boxOf(polygon);
  const std::size_t count = polygon.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec end = polygon[(i + 1) % count];
    const Vec along = end - polygon[i];
    const mpz_class x(along.y);
    const mpz_class y(-along.x);
    sides.push_back({x, y, x * polygon[i].x + y * polygon[i].y, polygon[i], end,
                     line.a != line.b && oracle::cross(along, line.b - line.a) == 0, (i + count - 1) % count,
                     (i + 1) % count});
  }
}

}  // namespace platon::reference
