#include "tests/bench/engines/falling_engine.h"

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace platon::bench {
namespace {

class FallingEngine : public Engine {
 public:
  FallingEngine(std::unique_ptr<Engine> engine, const Scene& scene)
      : engine_(std::move(engine)), gravity_(scene.gravity), velocities_(scene.bodies.size()) {
    for (std::size_t i = 0; i < velocities_.size(); ++i) heights_.push_back(engine_->position(i).y);
  }

  void setVelocity(std::size_t body, Place velocity) override {
    velocities_[body].x = velocity.x;
    if (velocity.y != 0) velocities_[body].y = velocity.y;
  }
  void step() override {
    for (std::size_t i = 0; i < velocities_.size(); ++i) {
      velocities_[i].y -= gravity_;
      engine_->setVelocity(i, velocities_[i]);
    }
    engine_->step();
    for (std::size_t i = 0; i < velocities_.size(); ++i) stopWhereBlocked(i);
  }
  Place position(std::size_t body) const override { return engine_->position(body); }

 private:
  void stopWhereBlocked(std::size_t body) {
    const double height = engine_->position(body).y;
    const double moved = height - std::exchange(heights_[body], height);
    if (std::abs(moved - velocities_[body].y) > gravity_ / 2) velocities_[body].y = 0;
  }

  std::unique_ptr<Engine> engine_;
  double gravity_;
  std::vector<Place> velocities_;
  std::vector<double> heights_;  // before the step
};

}  // namespace

std::unique_ptr<Engine> withGravity(std::unique_ptr<Engine> engine, const Scene& scene) {
  if (scene.gravity == 0) return engine;
  return std::make_unique<FallingEngine>(std::move(engine), scene);
}

}  // namespace platon::bench
