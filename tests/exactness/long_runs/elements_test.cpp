// Elements on random levels of every solid: the oracle checks every leg of players that press buttons, and of bodies at
// random velocities among doors that open and close at any time.
#include <gtest/gtest.h>

#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "platon/game/game.h"
#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "shared/game/element_rules.h"
#include "tests/exactness/oracle/random_source.h"
#include "tests/exactness/properties/seeded_cases.h"
#include "tests/exactness/step_check/run_length.h"
#include "tests/exactness/step_check/step_checker.h"
#include "tests/sim/churn.h"
#include "tests/support/element_level.h"

namespace platon::long_runs {
namespace {

using oracle::RandomSource;

constexpr std::uint32_t kPlayers = 4;
constexpr int kTicks = 1000;

std::shared_ptr<const Level> levelOf(std::uint64_t seed) {
  LevelResult result = loadLevel(elementLevel(static_cast<int>(seed % kSolidKinds), seed));
  for (const Diagnostic& found : result.diagnostics) {
    if (found.error) ADD_FAILURE() << format("seed " + std::to_string(seed), found);
  }
  return result.level;
}

step_check::CheckedScene sceneOf(const Level& level, const Convex& shape) {
  return {level.world.geometry(), shape, level.solid, level.faceSize, {}, level.elements};
}

class ElementsTest : public testing::Test {
 protected:
  // The levels of this many seeds.
  template <class Play>
  void onEachLevel(std::int64_t count, Play&& play) {
    const std::uint64_t first = properties::firstSeed();
    for (std::int64_t i = 0; i < count && !HasFailure(); ++i) {
      SCOPED_TRACE("PLATON_SEED=" + std::to_string(first + static_cast<std::uint64_t>(i)));
      const auto level = levelOf(first + static_cast<std::uint64_t>(i));
      if (level) play(level, first + static_cast<std::uint64_t>(i));
    }
    std::cout << "seeds from " << first << ": " << passed_ << " elements passed\n";
    EXPECT_GT(passed_, static_cast<std::size_t>(10 * count));
  }

  const Convex shape_ = playerShape();
  std::size_t passed_ = 0;
};

TEST_F(ElementsTest, InvariantsHoldForPlayers) {
  onEachLevel(step_check::runLength(60, 6000), [&](const auto& level, std::uint64_t seed) {
    step_check::StepChecker checker(sceneOf(*level, shape_));
    Game game(level);
    sim::Churn churn(seed, kPlayers);
    for (int tick = 0; tick < kTicks; ++tick) {
      const std::uint32_t open = game.openDoors();
      game.advance(churn.next(), &checker);
      ASSERT_EQ(checker.finishTick(open), "") << "tick " << tick;
    }
    passed_ += checker.elementsPassed();
  });
}

TEST_F(ElementsTest, InvariantsHoldWhileDoorsCloseOnBodies) {
  onEachLevel(step_check::runLength(60, 6000), [&](const auto& level, std::uint64_t seed) {
    step_check::StepChecker checker(sceneOf(*level, shape_));
    RandomSource random(seed);
    World world = level->world;
    std::uint32_t open = 0;
    for (std::uint32_t i = 0; i < kPlayers; ++i) {
      ElementRules rules(*level, open);
      world.setRules(rules);
      Entity entity(world, shape_);
      MapPart(world, level->startFace).insert(entity, level->start, level->startAngle);
    }
    for (int tick = 0; tick < kTicks; ++tick) {
      if (random.oneIn(3)) open ^= 1U << random.below(3);
      ElementRules rules(*level, open);
      world.setRules(rules);
      for (std::uint32_t i = 0; i < kPlayers; ++i) {
        const oracle::Vec velocity = random.vector(std::int64_t{1} << random.between(4, 15));
        if (random.oneIn(2))
          Entity(world, i).setVelocity({static_cast<std::int32_t>(velocity.x), static_cast<std::int32_t>(velocity.y)});
      }
      world.solve(&checker);
      ASSERT_EQ(checker.finishTick(open), "") << "tick " << tick;
    }
    passed_ += checker.elementsPassed();
  });
}

// The instance that is about to be home is moved by a subunit when its drift is corrected. In this game that moves it
// out of a one-way segment, through which it could then go back.
TEST_F(ElementsTest, ACorrectedDriftCanEndAContact) {
  constexpr std::uint64_t seed = 1487;
  const auto level = levelOf(seed);
  step_check::StepChecker checker(sceneOf(*level, shape_));
  Game game(level);
  sim::Churn churn(seed, kPlayers);
  for (int tick = 0; tick < 300; ++tick) {
    const std::uint32_t open = game.openDoors();
    game.advance(churn.next(), &checker);
    ASSERT_EQ(checker.finishTick(open), "") << "tick " << tick;
  }
}

}  // namespace
}  // namespace platon::long_runs
