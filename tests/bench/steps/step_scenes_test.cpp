#include "tests/bench/steps/step_scenes.h"

#include <gtest/gtest.h>

namespace platon::bench::step_scenes_test {
namespace {

TEST(StepScenes, HaveTheSegmentsAndBodiesAskedFor) {
  for (const StepScenes* scenes : {&randomScenes(), &platformerScenes()}) {
    for (const std::size_t segments : {100u, 1000u}) {
      const Scene scene = scenes->make(segments, 64);
      EXPECT_EQ(scene.segments.size(), segments) << scenes->name;
      EXPECT_EQ(scene.bodies.size(), 64u) << scenes->name;
    }
  }
}

TEST(StepScenes, OnlyThePlatformerHasGravity) {
  EXPECT_EQ(randomScenes().make(100, 1).gravity, 0);
  EXPECT_GT(platformerScenes().make(100, 1).gravity, 0);
}

TEST(StepScenes, AThirdOfThePlatformersBodiesStand) {
  sim::SeededRandom random(1);
  for (std::size_t body = 0; body < 12; ++body) {
    const Place velocity = platformerScenes().velocityOf(body, random);
    EXPECT_EQ(velocity.x == 0 && velocity.y == 0, body % 3 == 0) << body;
  }
}

}  // namespace
}  // namespace platon::bench::step_scenes_test
