#include "tests/exactness/oracle/sweep/sweep_families.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numeric>

#include "tests/exactness/oracle/sweep/random_shapes.h"
#include "tests/exactness/oracle/sweep/sweep_oracle.h"

namespace platon::oracle {
namespace {

constexpr std::int64_t kLargest = kCoordinateLimit - 1;

constexpr auto kFamilies = std::to_array<SweepFamily>({
    {"tiny", 4, ShapeKind::Any, SegmentKind::Any, Aim::Random},
    {"small", 8, ShapeKind::Any, SegmentKind::Any, Aim::Random},
    {"small box", 8, ShapeKind::Box, SegmentKind::Any, Aim::Random},
    {"medium", 1000, ShapeKind::Any, SegmentKind::Any, Aim::EndsNearVertex},
    {"large", kLargest, ShapeKind::Any, SegmentKind::Any, Aim::EndsNearVertex},
    {"large anywhere", kLargest, ShapeKind::Any, SegmentKind::Any, Aim::Random},
    {"extreme box", kLargest, ShapeKind::Box, SegmentKind::Any, Aim::Random},
    {"ball of a player", 1 << 20, ShapeKind::Ball, SegmentKind::Any, Aim::EndsNearVertex},
    {"ball against a point", 1 << 20, ShapeKind::Ball, SegmentKind::Point, Aim::ThroughVertex},
    {"many vertices", 1 << 20, ShapeKind::ManyVertices, SegmentKind::Any, Aim::EndsNearVertex},
    {"many vertices, parallel line", 1 << 20, ShapeKind::ManyVertices, SegmentKind::Parallel, Aim::AlongEdge},
    {"many vertices, large", kLargest, ShapeKind::ManyVertices, SegmentKind::NearlyParallel, Aim::ThroughVertex},
    {"point, small", 8, ShapeKind::Any, SegmentKind::Point, Aim::ThroughVertex},
    {"point, large", kLargest, ShapeKind::Any, SegmentKind::Point, Aim::EndsNearVertex},
    {"vertex, small", 30, ShapeKind::Any, SegmentKind::Any, Aim::ThroughVertex},
    {"vertex, medium", 5000, ShapeKind::Any, SegmentKind::Parallel, Aim::ThroughVertex},
    {"vertex, large", kLargest, ShapeKind::Any, SegmentKind::Any, Aim::ThroughVertex},
    {"vertex, needle", kLargest, ShapeKind::Needle, SegmentKind::NearlyParallel, Aim::ThroughVertex},
    {"edge, small", 30, ShapeKind::Any, SegmentKind::Any, Aim::AlongEdge},
    {"edge, parallel line", 5000, ShapeKind::Any, SegmentKind::Parallel, Aim::AlongEdge},
    {"edge, large", kLargest, ShapeKind::Box, SegmentKind::EdgeCopy, Aim::AlongEdge},
    {"edge, ball", 1 << 20, ShapeKind::Ball, SegmentKind::EdgeCopy, Aim::AlongEdge},
    {"tangent, small", 30, ShapeKind::Any, SegmentKind::Any, Aim::Tangent},
    {"tangent, large", kLargest, ShapeKind::Any, SegmentKind::NearlyParallel, Aim::Tangent},
    {"starts on the boundary, small", 30, ShapeKind::Any, SegmentKind::Any, Aim::StartsOnBoundary},
    {"starts on the boundary, parallel line", 1 << 20, ShapeKind::Ball, SegmentKind::Parallel, Aim::StartsOnBoundary},
    {"starts on the boundary, large", kLargest, ShapeKind::Any, SegmentKind::EdgeCopy, Aim::StartsOnBoundary},
    {"starts on the boundary, needle", kLargest, ShapeKind::Needle, SegmentKind::Any, Aim::StartsOnBoundary},
    {"ends on the boundary, small", 30, ShapeKind::Any, SegmentKind::Any, Aim::EndsOnBoundary},
    {"ends on the boundary, ball", 1 << 20, ShapeKind::Ball, SegmentKind::Parallel, Aim::EndsOnBoundary},
    {"ends on the boundary, large", kLargest, ShapeKind::Any, SegmentKind::Any, Aim::EndsOnBoundary},
    {"ends on the boundary, needle", kLargest, ShapeKind::Needle, SegmentKind::NearlyParallel, Aim::EndsOnBoundary},
    {"starts inside, small", 30, ShapeKind::Any, SegmentKind::Any, Aim::StartsInside},
    {"starts inside, large", kLargest, ShapeKind::Needle, SegmentKind::Any, Aim::StartsInside},
    {"no displacement, small", 8, ShapeKind::Any, SegmentKind::Any, Aim::NoDisplacement},
    {"no displacement, large", kLargest, ShapeKind::Any, SegmentKind::Parallel, Aim::NoDisplacement},
    {"needles", 1 << 28, ShapeKind::Needle, SegmentKind::NearlyParallel, Aim::EndsNearVertex},
    {"nearly along an edge, small", 100, ShapeKind::Any, SegmentKind::Any, Aim::NearlyAlongEdge},
    {"nearly along an edge, large", kLargest, ShapeKind::Any, SegmentKind::NearlyParallel, Aim::NearlyAlongEdge},
    {"nearly along an edge, needle", kLargest, ShapeKind::Needle, SegmentKind::NearlyParallel, Aim::NearlyAlongEdge},
});

/// The shortest lattice vector with the direction of v.
Vec primitive(Vec v) {
  const std::int64_t divisor = std::gcd(v.x, v.y);
  return divisor == 0 ? v : Vec{v.x / divisor, v.y / divisor};
}

/// How many steps fit into `scale`; at least one.
std::int64_t stepsWithin(std::int64_t scale, Vec step) {
  return std::max<std::int64_t>(1, scale / std::max<std::int64_t>({1, std::abs(step.x), std::abs(step.y)}));
}

/// Zero, or with probability 1/3 up to one subunit along each axis.
Vec jitter(RandomSource& random) { return random.oneIn(3) ? random.vector(1) : Vec{}; }

/// Chooses position and displacement of a query relative to its obstacle.
class Aimer {
 public:
  Aimer(const SweepFamily& family, SweepQuery& query, RandomSource& random)
      : family_(family), query_(query), random_(random), obstacle_(obstacleOf(query)) {
    edge_ = random.below(obstacle_.size());
    start_ = obstacle_[edge_];
    along_ = obstacle_[(edge_ + 1) % obstacle_.size()] - start_;
    before_ = start_ - obstacle_[(edge_ + obstacle_.size() - 1) % obstacle_.size()];
  }

  void aim() {
    switch (family_.aim) {
      case Aim::Random:
        return set(random_.vector(family_.scale), random_.vector(family_.scale));
      case Aim::EndsNearVertex:
        return towards(start_ + random_.vector(family_.scale / 4));
      case Aim::ThroughVertex:
        return throughVertex(primitive(random_.vector(directionLimit())));
      case Aim::AlongEdge:
        return alongEdge();
      case Aim::Tangent:
        return throughVertex(primitive(before_ + along_));
      case Aim::StartsOnBoundary:
        return set(boundaryPoint(), direction());
      case Aim::EndsOnBoundary:
        return towards(boundaryPoint() + jitter(random_));
      case Aim::StartsInside:
        return set(insidePoint(), random_.vector(family_.scale));
      case Aim::NoDisplacement:
        return set(stillPoint(), {});
      case Aim::NearlyAlongEdge:
        return almostAlong();
    }
  }

 private:
  void set(Vec position, Vec displacement) {
    query_.position = position;
    query_.displacement = displacement;
  }

  void towards(Vec end) {
    const Vec position = random_.vector(family_.scale);
    set(position, end - position);
  }

  /// Largest component of a direction. Short directions give hits at simple fractions, long ones at large terms.
  std::int64_t directionLimit() {
    return random_.oneIn(2) ? std::min<std::int64_t>(family_.scale, 5) : family_.scale / 4 + 1;
  }

  void throughVertex(Vec step) {
    const std::int64_t maxSteps = stepsWithin(family_.scale, step);
    const std::int64_t ahead = random_.between(0, maxSteps / 2);
    set(start_ - ahead * step + jitter(random_), random_.between(ahead / 2, maxSteps) * step + jitter(random_));
  }

  void alongEdge() {
    const Vec step = random_.oneIn(2) ? primitive(along_) : -primitive(along_);
    const std::int64_t maxSteps = stepsWithin(family_.scale, step);
    const Vec from = start_ + random_.between(-maxSteps / 2, maxSteps / 2) * step;
    set(from + jitter(random_), random_.between(0, maxSteps) * step + (random_.oneIn(4) ? random_.vector(1) : Vec{}));
  }

  void almostAlong() {
    const Vec step = random_.oneIn(2) ? along_ : -along_;
    const Vec from = start_ + random_.vector(3);
    set(random_.oneIn(2) ? from : from - step, step + random_.vector(2));
  }

  Vec boundaryPoint() {
    const Vec step = primitive(along_);
    return start_ + random_.between(0, std::gcd(along_.x, along_.y)) * step;
  }

  Vec direction() {
    if (random_.oneIn(4)) return random_.oneIn(2) ? along_ : -along_;
    if (random_.oneIn(4)) return random_.vector(2);
    return random_.vector(family_.scale);
  }

  Vec insidePoint() {
    Vec sum = start_ + along_ + start_ - before_;
    sum = sum + start_;
    return {sum.x / 3, sum.y / 3};
  }

  Vec stillPoint() {
    if (random_.oneIn(3)) return insidePoint();
    return random_.oneIn(2) ? boundaryPoint() + jitter(random_) : random_.vector(family_.scale);
  }

  const SweepFamily& family_;
  SweepQuery& query_;
  RandomSource& random_;
  Polygon obstacle_;
  std::size_t edge_ = 0;
  Vec start_;
  Vec along_;
  Vec before_;
};

}  // namespace

std::span<const SweepFamily> sweepFamilies() { return kFamilies; }

SweepQuery makeQuery(const SweepFamily& family, RandomSource& random) {
  SweepQuery query;
  do {
    query.shape = randomShape(family.shape, family.scale, random);
    query.segment = randomSegment(family.segment, query.shape, family.scale, random);
    Aimer(family, query, random).aim();
  } while (!isValid(query));
  return query;
}

}  // namespace platon::oracle
