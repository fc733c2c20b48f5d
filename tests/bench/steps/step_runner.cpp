#include "tests/bench/steps/step_runner.h"

#include <utility>

#include "tests/bench/measure.h"

namespace platon::bench {
namespace {

constexpr std::uint64_t kSeed = 8;

}  // namespace

StepRunner::StepRunner(const StepScenes& scenes, std::unique_ptr<Engine> engine, const Scene& scene)
    : scenes_(scenes),
      engine_(std::move(engine)),
      hasGravity_(scene.gravity > 0),
      random_(kSeed),
      velocities_(scene.bodies.size()) {}

double StepRunner::run(std::int64_t steps) {
  const std::int64_t velocities = (steps + kStepsOfOneVelocity - 1) / kStepsOfOneVelocity;
  const double spent = nanosecondsOf([&] {
    for (std::int64_t i = 0; i < velocities; ++i) runOneVelocity();
  });
  return spent / static_cast<double>(velocities * kStepsOfOneVelocity) / static_cast<double>(velocities_.size());
}

void StepRunner::runOneVelocity() {
  for (std::size_t i = 0; i < velocities_.size(); ++i) velocities_[i] = scenes_.velocityOf(i, random_);
  for (int step = 0; step < kStepsOfOneVelocity; ++step) {
    for (std::size_t i = 0; i < velocities_.size(); ++i) {
      if (hasGravity_ && velocities_[i].x == 0) continue;  // stands
      engine_->setVelocity(i, velocities_[i]);
      if (hasGravity_) velocities_[i].y = 0;  // the jump has begun
    }
    engine_->step();
  }
}

}  // namespace platon::bench
