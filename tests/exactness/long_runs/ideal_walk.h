#pragma once

#include <cstdint>
#include <vector>

#include "platon/exact/angle.h"
#include "platon/exact/point.h"
#include "platon/game/solid.h"
#include "platon/physics/step_observer.h"
#include "tests/exactness/oracle/trace/solid_model.h"

namespace platon::long_runs {

/// A point that moves straight over the ideal faces of a solid. It observes an entity and changes faces when the entity
/// rehomes, so that both are always in the same frame.
///
/// Accurate to 1e-7 subunits after a million crossings: each is one isometry in `long double`, with an error of a few
/// 2^-64 of the face size, and the direction is computed from the total rotation.
class IdealWalk : public StepObserver {
 public:
  IdealWalk(SolidKind kind, std::int32_t faceSize, std::uint32_t face, Point start);

  void leg(std::uint32_t entity, std::span<const InstanceView> instances) override;
  /// Moves by `velocity`, given in the frame of the start.
  void advance(Point velocity) { place_ = sum(place_, turned(velocity)); }

  oracle::RealVec place() const { return place_; }
  /// Rotation from the frame of the start to the current frame.
  Angle heading() const { return heading_; }
  std::int64_t crossings() const { return crossings_; }
  /// `vector`, given in the frame of the start, in the current frame.
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
