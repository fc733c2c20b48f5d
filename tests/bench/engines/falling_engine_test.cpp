#include "tests/bench/engines/falling_engine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "tests/shared/physics/shapes.h"

namespace platon::bench::falling_engine_test {
namespace {

constexpr std::int32_t kMetre = static_cast<std::int32_t>(kSubunitsPerMetre);
constexpr std::int32_t kRadius = 12 * kSubunitsPerUnit;
/// Box2D keeps a gap of 15 mm, Chipmunk overlaps by 5 mm.
constexpr double kSlop = kSubunitsPerMetre / 50;

/// A body above a floor of two tiles, in every engine.
class FallingEngineTest : public testing::TestWithParam<EngineKind> {
 protected:
  void step(int times) {
    for (int i = 0; i < times; ++i) engine_->step();
  }
  double height() const { return engine_->position(0).y - static_cast<double>(scene_.shape.bounds().high.y); }

  const Scene scene_{.segments = {{{-50 * kMetre, 0}, {0, 0}}, {{0, 0}, {50 * kMetre, 0}}},
                     .shape = regular(8, kRadius),
                     .bodies = {{0, 2 * kMetre}},
                     .gravity = 80};
  const std::unique_ptr<Engine> engine_ = GetParam().make(scene_);
};

TEST_P(FallingEngineTest, ABodyWithoutVelocityFallsAndStands) {
  step(10);
  EXPECT_LT(height(), 2 * kMetre - kRadius);
  step(300);
  EXPECT_NEAR(height(), 0, kSlop);
  const double rest = height();
  step(300);
  EXPECT_NEAR(height(), rest, 1);
  EXPECT_NEAR(engine_->position(0).x, 0, 1);
}

TEST_P(FallingEngineTest, AJumpIsAsHighAsItsSpeedAllows) {
  constexpr double kJump = 2184;
  step(300);
  const double rest = height();
  engine_->setVelocity(0, {1, kJump});
  double highest = 0;
  for (int i = 0; i < 60; ++i) {
    step(1);
    highest = std::max(highest, height() - rest);
  }
  EXPECT_NEAR(highest, kJump * kJump / (2 * scene_.gravity), kJump);
  step(30);
  EXPECT_NEAR(height(), rest, kSlop);
}

TEST_P(FallingEngineTest, WalksAtItsSpeed) {
  constexpr double kSpeed = 1000;
  step(300);
  for (int i = 0; i < 100; ++i) {
    engine_->setVelocity(0, {kSpeed, 0});
    step(1);
  }
  EXPECT_NEAR(engine_->position(0).x, 100 * kSpeed, 2 * kSpeed);
  EXPECT_NEAR(height(), 0, kSlop);
}

std::vector<EngineKind> kinds() {
  std::vector<EngineKind> kinds = engineKinds();
  kinds.push_back({kComputed, &makePlatonComputed});
  kinds.push_back({kIdealPlace, &makePlatonIdealPlace});
  return kinds;
}

std::string nameOf(const testing::TestParamInfo<EngineKind>& test) {
  std::string name = test.param.name;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '-' || c == '.' || c == '+'; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(EveryEngine, FallingEngineTest, testing::ValuesIn(kinds()), &nameOf);

}  // namespace
}  // namespace platon::bench::falling_engine_test
