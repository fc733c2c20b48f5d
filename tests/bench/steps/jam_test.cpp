#include "tests/bench/steps/jam.h"

#include <gtest/gtest.h>

#include <memory>
#include <utility>

#include "tests/bench/steps/step_scenes.h"

namespace platon::bench::jam_test {
namespace {

constexpr std::size_t kSegments = 100;
constexpr std::size_t kBodies = 16;

/// An engine in which no body ever moves.
class StuckEngine : public Engine {
 public:
  explicit StuckEngine(const Scene& scene) : bodies_(scene.bodies) {}

  void setVelocity(std::size_t, Place) override {}
  void step() override {}
  Place position(std::size_t body) const override {
    return {static_cast<double>(bodies_[body].x), static_cast<double>(bodies_[body].y)};
  }

 private:
  std::vector<Point> bodies_;
};

Jams jamsOf(const StepScenes& scenes, std::unique_ptr<Engine> (*make)(const Scene&)) {
  const Scene scene = scenes.make(kSegments, kBodies);
  StepRunner runner(scenes, make(scene), scene);
  runner.run(120);
  return countJams(runner, scene);
}

std::unique_ptr<Engine> makeStuck(const Scene& scene) { return std::make_unique<StuckEngine>(scene); }

TEST(Jam, ABodyThatNeverMovesIsJammedWhereverTheIdealMoves) {
  const Jams random = jamsOf(randomScenes(), &makeStuck);
  EXPECT_EQ(random.halfSeconds, 256u);
  EXPECT_GT(random.share(), 0.7);
  EXPECT_GT(jamsOf(platformerScenes(), &makeStuck).share(), 0.5);
}

TEST(Jam, StandingBodiesDoNotCount) {
  EXPECT_EQ(jamsOf(platformerScenes(), &makePlaton).halfSeconds, 16 * (kBodies - (kBodies + 2) / 3));
}

TEST(Jam, PlatonAndFloat64DoNotJam) {
  for (const auto make : {&makePlaton, &makeFloat64}) {
    EXPECT_EQ(jamsOf(randomScenes(), make).jammed, 0u);
    EXPECT_EQ(jamsOf(platformerScenes(), make).jammed, 0u);
  }
}

}  // namespace
}  // namespace platon::bench::jam_test
