#pragma once

#include <cstdint>
#include <vector>

#include "platon/exact/angle.h"
#include "platon/exact/point.h"
#include "platon/game/solid.h"
#include "platon/physics/step_observer.h"
#include "tests/exactness/oracle/trace/solid_model.h"

namespace platon::long_runs {

/// Where a point that goes straight over the ideal faces of a solid is. Its crossings are those of an entity: it
/// changes faces together with the home of the entity that it is told of, so that both are always in one frame.
///
/// Good to 1e-7 subunits after a million crossings: each is one isometry in `long double`, off by a few 2^-64 of the
/// size of a face, and the direction is never turned twice.
class IdealWalk : public StepObserver {
 public:
  IdealWalk(SolidKind kind, std::int32_t faceSize, std::uint32_t face, Point start);

  void leg(std::uint32_t entity, std::span<const InstanceView> instances) override;
  /// `velocity` of the walker, given in the frame it began in.
  void advance(Point velocity) { place_ = sum(place_, turned(velocity)); }

  oracle::RealVec place() const { return place_; }
  /// All turns of the frame so far.
  Angle heading() const { return heading_; }
  std::int64_t crossings() const { return crossings_; }
  /// The same vector in the present frame.
  oracle::RealVec turned(Point vector) const;

 private:
  static oracle::RealVec sum(oracle::RealVec a, oracle::RealVec b) { return {a.x + b.x, a.y + b.y}; }
  void cross(std::uint32_t face);

  const PlatonicSolid& solid_;
  long double edgeLength_;
  std::uint32_t face_;
  oracle::RealVec place_;
  Angle heading_;
  std::int64_t crossings_ = 0;
};

}  // namespace platon::long_runs
