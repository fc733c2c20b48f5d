#include <gmpxx.h>

#include <algorithm>

#include "tests/exactness/oracle/sweep/sweep_oracle.h"

namespace platon::oracle {
namespace {

/// The shape of a query at a given time.
class Placement {
 public:
  Placement(const SweepQuery& query, const mpq_class& time)
      : query_(query),
        x_(mpq_class(query.position.x) + time * query.displacement.x),
        y_(mpq_class(query.position.y) + time * query.displacement.y) {}

  /// True if the open shape contains a point of the segment.
  bool overlaps() const { return clip(true); }
  /// True if the closed shape contains a point of the segment.
  bool touches() const { return clip(false); }

  /// True if a line with this normal separates shape and segment, and both touch that line.
  bool isSeparatedBy(Vec normal) const {
    const auto height = [&](Vec v) -> mpq_class { return mpq_class(normal.x) * v.x + mpq_class(normal.y) * v.y; };
    mpq_class lowest = height(query_.shape.front());
    for (const Vec vertex : query_.shape) lowest = std::min<mpq_class>(lowest, height(vertex));
    lowest += normal.x * x_ + normal.y * y_;
    return lowest == std::max<mpq_class>(height(query_.segment.a), height(query_.segment.b));
  }

 private:
  /// Signed distance of `point` from an edge, positive inside, times the edge's length.
  mpq_class depth(std::size_t edge, Vec point) const {
    const Vec start = query_.shape[edge];
    const Vec along = query_.shape[(edge + 1) % query_.shape.size()] - start;
    return along.x * (mpq_class(point.y - start.y) - y_) - along.y * (mpq_class(point.x - start.x) - x_);
  }

  /// True if the open or the closed shape contains a part of the segment.
  bool clip(bool open) const {
    mpq_class low = 0;
    mpq_class high = 1;
    for (std::size_t i = 0; i < query_.shape.size(); ++i) {
      const mpq_class a = depth(i, query_.segment.a);
      const mpq_class b = depth(i, query_.segment.b);
      const int inner = std::max(sgn(a), sgn(b));
      if (inner < 0 || (open && inner == 0)) return false;
      if (a == b) continue;
      const mpq_class crossing = a / (a - b);
      if (a <= 0 && crossing > low) low = crossing;
      if (b <= 0 && crossing < high) high = crossing;
      if (low > high || (open && low == high)) return false;
    }
    return true;
  }

  const SweepQuery& query_;
  mpq_class x_;
  mpq_class y_;
};

/// True if the open shape overlaps the segment at times arbitrarily soon after `time`. The times at which two convex
/// sets overlap are an interval, so an overlap a little later and a touch at `time` prove it.
bool overlapsSoonAfter(const SweepQuery& query, const mpq_class& time) {
  // Numerators and denominators of all event times are below 2^63, so no overlap is shorter than 2^-126.
  mpq_class later = (1 - time) / 2;
  for (int i = 0; i < 34; ++i, later /= 16)
    if (Placement(query, time + later).overlaps()) return true;
  return false;
}

bool isEdgeOfObstacle(const SweepQuery& query, Vec normal) {
  const Polygon& shape = query.shape;
  if (dot(query.segment.b - query.segment.a, normal) == 0 && query.segment.a != query.segment.b) return true;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const Vec along = shape[(i + 1) % shape.size()] - shape[i];
    if (dot(along, normal) == 0 && cross(along, normal) > 0) return true;
  }
  return false;
}

bool confirmsHit(const SweepQuery& query, const CorrectAnswer& correct) {
  mpq_class time(static_cast<std::int64_t>(correct.numerator), static_cast<std::int64_t>(correct.denominator));
  time.canonicalize();
  const Placement contact(query, time);
  const auto isRightNormal = [&](Vec normal) {
    return dot(normal, query.displacement) < 0 && isEdgeOfObstacle(query, normal) && contact.isSeparatedBy(normal);
  };
  return time >= 0 && time < 1 && contact.touches() && !contact.overlaps() && overlapsSoonAfter(query, time) &&
         !correct.normals.empty() && std::all_of(correct.normals.begin(), correct.normals.end(), isRightNormal);
}

}  // namespace

bool confirms(const SweepQuery& query, const CorrectAnswer& correct) {
  if (correct.kind == CorrectAnswer::Kind::Overlap) return Placement(query, 0).overlaps();
  if (Placement(query, 0).overlaps()) return false;
  if (correct.kind == CorrectAnswer::Kind::Hit) return confirmsHit(query, correct);
  return !OpenArea::swept(query.shape, query.position, query.displacement).intersects(query.segment);
}

}  // namespace platon::oracle
