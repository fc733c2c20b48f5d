#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "tests/bench/engines/engine.h"
#include "tests/bench/steps/step_scenes.h"
#include "tests/sim/seeded_random.h"

namespace platon::bench {

/// One engine with the bodies of one scene. Every runner of a scene gives its bodies the same velocities.
class StepRunner {
 public:
  StepRunner(const StepScenes& scenes, std::unique_ptr<Engine> engine, const Scene& scene);

  /// Runs at least `steps` steps. Returns nanoseconds per body and step.
  double run(std::int64_t steps);
  /// Draws new velocities and runs kStepsOfOneVelocity steps.
  void runOneVelocity();
  /// The velocity of a body in the last step, without that of a jump.
  Place velocity(std::size_t body) const { return velocities_[body]; }
  const Engine& engine() const { return *engine_; }

 private:
  const StepScenes& scenes_;
  std::unique_ptr<Engine> engine_;
  bool hasGravity_;
  sim::SeededRandom random_;
  std::vector<Place> velocities_;
};

}  // namespace platon::bench
