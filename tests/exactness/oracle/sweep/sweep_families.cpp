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
    {"tiny", 4, ShapeKind::Any, LineKind::Any, Aim::Anywhere},
    {"small", 8, ShapeKind::Any, LineKind::Any, Aim::Anywhere},
    {"small box", 8, ShapeKind::Box, LineKind::Any, Aim::Anywhere},
    {"medium", 1000, ShapeKind::Any, LineKind::Any, Aim::Towards},
    {"large", kLargest, ShapeKind::Any, LineKind::Any, Aim::Towards},
    {"large anywhere", kLargest, ShapeKind::Any, LineKind::Any, Aim::Anywhere},
    {"extreme box", kLargest, ShapeKind::Box, LineKind::Any, Aim::Anywhere},
    {"ball like a player", 1 << 20, ShapeKind::Ball, LineKind::Any, Aim::Towards},
    {"ball against a point", 1 << 20, ShapeKind::Ball, LineKind::Point, Aim::Corner},
    {"many corners", 1 << 20, ShapeKind::Many, LineKind::Any, Aim::Towards},
    {"many corners, parallel line", 1 << 20, ShapeKind::Many, LineKind::Along, Aim::Edge},
    {"many corners, large", kLargest, ShapeKind::Many, LineKind::Almost, Aim::Corner},
    {"point, small", 8, ShapeKind::Any, LineKind::Point, Aim::Corner},
    {"point, large", kLargest, ShapeKind::Any, LineKind::Point, Aim::Towards},
    {"corner, small", 30, ShapeKind::Any, LineKind::Any, Aim::Corner},
    {"corner, medium", 5000, ShapeKind::Any, LineKind::Along, Aim::Corner},
    {"corner, large", kLargest, ShapeKind::Any, LineKind::Any, Aim::Corner},
    {"corner, needle", kLargest, ShapeKind::Needle, LineKind::Almost, Aim::Corner},
    {"edge, small", 30, ShapeKind::Any, LineKind::Any, Aim::Edge},
    {"edge, parallel line", 5000, ShapeKind::Any, LineKind::Along, Aim::Edge},
    {"edge, large", kLargest, ShapeKind::Box, LineKind::Copy, Aim::Edge},
    {"edge, ball", 1 << 20, ShapeKind::Ball, LineKind::Copy, Aim::Edge},
    {"tangent, small", 30, ShapeKind::Any, LineKind::Any, Aim::Tangent},
    {"tangent, large", kLargest, ShapeKind::Any, LineKind::Almost, Aim::Tangent},
    {"starting, small", 30, ShapeKind::Any, LineKind::Any, Aim::Starting},
    {"starting, parallel line", 1 << 20, ShapeKind::Ball, LineKind::Along, Aim::Starting},
    {"starting, large", kLargest, ShapeKind::Any, LineKind::Copy, Aim::Starting},
    {"starting, needle", kLargest, ShapeKind::Needle, LineKind::Any, Aim::Starting},
    {"ending, small", 30, ShapeKind::Any, LineKind::Any, Aim::Ending},
    {"ending, ball", 1 << 20, ShapeKind::Ball, LineKind::Along, Aim::Ending},
    {"ending, large", kLargest, ShapeKind::Any, LineKind::Any, Aim::Ending},
    {"ending, needle", kLargest, ShapeKind::Needle, LineKind::Almost, Aim::Ending},
    {"overlapping, small", 30, ShapeKind::Any, LineKind::Any, Aim::Overlapping},
    {"overlapping, large", kLargest, ShapeKind::Needle, LineKind::Any, Aim::Overlapping},
    {"still, small", 8, ShapeKind::Any, LineKind::Any, Aim::Still},
    {"still, large", kLargest, ShapeKind::Any, LineKind::Along, Aim::Still},
    {"needles", 1 << 28, ShapeKind::Needle, LineKind::Almost, Aim::Towards},
    {"almost along, small", 100, ShapeKind::Any, LineKind::Any, Aim::AlmostAlong},
    {"almost along, large", kLargest, ShapeKind::Any, LineKind::Almost, Aim::AlmostAlong},
    {"almost along, needle", kLargest, ShapeKind::Needle, LineKind::Almost, Aim::AlmostAlong},
});

/// The shortest lattice vector of the same direction.
Vec primitive(Vec v) {
  const std::int64_t divisor = std::gcd(v.x, v.y);
  return divisor == 0 ? v : Vec{v.x / divisor, v.y / divisor};
}

/// How often the primitive vector `step` fits into `scale`.
std::int64_t stepsWithin(std::int64_t scale, Vec step) {
  return std::max<std::int64_t>(1, scale / std::max<std::int64_t>({1, std::abs(step.x), std::abs(step.y)}));
}

/// Sometimes one subunit, mostly nothing.
Vec jitter(RandomSource& random) { return random.oneIn(3) ? random.vector(1) : Vec{}; }

/// Places a query's path in respect of its forbidden polygon.
class Aimer {
 public:
  Aimer(const SweepFamily& family, SweepQuery& query, RandomSource& random)
      : family_(family), query_(query), random_(random), forbidden_(forbiddenPolygon(query)) {
    edge_ = random.below(forbidden_.size());
    start_ = forbidden_[edge_];
    along_ = forbidden_[(edge_ + 1) % forbidden_.size()] - start_;
    before_ = start_ - forbidden_[(edge_ + forbidden_.size() - 1) % forbidden_.size()];
  }

  void aim() {
    switch (family_.aim) {
      case Aim::Anywhere:
        return set(random_.vector(family_.scale), random_.vector(family_.scale));
      case Aim::Towards:
        return towards(start_ + random_.vector(family_.scale / 4));
      case Aim::Corner:
        return throughCorner(primitive(random_.vector(reach())));
      case Aim::Edge:
        return alongEdge();
      case Aim::Tangent:
        return throughCorner(primitive(before_ + along_));
      case Aim::Starting:
        return set(boundaryPoint(), direction());
      case Aim::Ending:
        return towards(boundaryPoint() + jitter(random_));
      case Aim::Overlapping:
        return set(insidePoint(), random_.vector(family_.scale));
      case Aim::Still:
        return set(stillPoint(), {});
      case Aim::AlmostAlong:
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

  /// Short directions give many lattice points on the path and hits at simple fractions; long ones give large terms.
  std::int64_t reach() { return random_.oneIn(2) ? std::min<std::int64_t>(family_.scale, 5) : family_.scale / 4 + 1; }

  void throughCorner(Vec step) {
    const std::int64_t most = stepsWithin(family_.scale, step);
    const std::int64_t ahead = random_.between(0, most / 2);
    set(start_ - ahead * step + jitter(random_), random_.between(ahead / 2, most) * step + jitter(random_));
  }

  void alongEdge() {
    const Vec step = random_.oneIn(2) ? primitive(along_) : -primitive(along_);
    const std::int64_t most = stepsWithin(family_.scale, step);
    const Vec from = start_ + random_.between(-most / 2, most / 2) * step;
    set(from + jitter(random_), random_.between(0, most) * step + (random_.oneIn(4) ? random_.vector(1) : Vec{}));
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
  Polygon forbidden_;
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
    query.obstacle = randomLine(family.line, query.shape, family.scale, random);
    Aimer(family, query, random).aim();
  } while (!isValid(query));
  return query;
}

}  // namespace platon::oracle
