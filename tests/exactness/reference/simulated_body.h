#pragma once

#include <cstdint>

#include "platon/physics/world.h"
#include "tests/exactness/reference/exact_scene.h"
#include "tests/exactness/reference/judged_body.h"
#include "tests/exactness/reference/rational_vec.h"

namespace platon::reference {

/// The body of a scene in the simulation.
class SimulatedBody : public JudgedBody {
 public:
  explicit SimulatedBody(const ExactScene& scene);

  void tick() override;
  RationalVec position() const override;
  RationalVec precisePosition() const override;
  /// Number of legs so far.
  std::int64_t legs() const { return legs_; }

 private:
  World world_;
  Point velocity_;
  std::int64_t legs_ = 0;
};

/// Distance of two points, rounded to double.
double distance(const RationalVec& a, const RationalVec& b);

}  // namespace platon::reference
