// Elements on random levels of every solid: the oracle checks every leg of players that press buttons, and of bodies at
// random velocities among doors that open and close at any time.
#include <gtest/gtest.h>

#include <cstdlib>
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
#include "tests/shared/game/real_face.h"
#include "tests/sim/churn.h"
#include "tests/support/element_level.h"
#include "tests/support/files.h"
#include "tests/support/run/repetitions.h"

namespace platon::long_runs::elements_test {
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

// The level has an element of each kind: level_drawing_test. So have the random levels of other tests: level_fuzz_test.
TEST_F(ElementsTest, TheOracleKnowsTheWordsOfAllKinds) {
  const LevelResult result = loadLevel(readText("tests/levels/picture/elements.level"));
  ASSERT_TRUE(result.level);
  EXPECT_EQ(step_check::StepChecker(sceneOf(*result.level, shape_)).finishTick(), "");
}

TEST_F(ElementsTest, InvariantsHoldForPlayers) {
  onEachLevel(step_check::runLength(60, 6000), [&](const auto& level, std::uint64_t seed) {
    step_check::StepChecker checker(sceneOf(*level, shape_));
    Game game(level);
    sim::Churn churn(seed, kPlayers);
    for (int tick = 0; tick < kTicks; ++tick) {
      const OpenElements open = game.open();
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
    OpenElements open;
    for (std::uint32_t i = 0; i < kPlayers; ++i) {
      ElementRules rules(*level, open);
      world.setRules(rules);
      Entity entity(world, shape_);
      MapPart(world, level->startFace).insert(entity, level->start, level->startAngle);
    }
    for (int tick = 0; tick < kTicks; ++tick) {
      if (random.oneIn(3)) open.doors ^= 1U << random.below(3);
      open.tick = static_cast<std::uint32_t>(tick);
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

// Doors five subunits apart, in three directions, where a ball touches them whose centre is in the middle of edge 0 of
// face 5.
std::string textWithDoorsRoundAnEdge() {
  const double inradius = RealFace(SolidKind::kDodecahedron, 480).inradius();
  std::string text = "DODECAHEDRON\n0 0 0 0\n11 0 0\n480\n%\n%\n%\n%\n%\n%\n";
  const auto add = [&](Real point) {
    for (const double number : {point.x, point.y - inradius}) {
      const std::string written = std::to_string(number / 1024);
      text += written.substr(0, written.size() - 2) + " ";
    }
  };
  for (int i = 0; i < 150; ++i) {
    for (const int degrees : {30, 90, 150}) {
      const Real normal = turned({1, 0}, Angle::degrees(degrees));
      const Real nearest = (11.7 * 1024 + 5 * i) * normal;
      add(nearest - 8000 * left(normal));
      add(nearest + 8000 * left(normal));
      text += "door 0\n";
    }
  }
  for (int i = 6; i < 12; ++i) text += "%\n";
  return text;
}

// Before an instance becomes home, its drift is corrected by a subunit or two. That can move it out of a door that has
// closed on it: it may not enter the door again. The ball stops just before edge 0 of face 0, which is edge 0 of
// face 1.
TEST_F(ElementsTest, ADoorThatIsLeftByACorrectedDriftIsNotEnteredAgain) {
  LevelResult loaded = loadLevel(textWithDoorsRoundAnEdge());
  ASSERT_NE(loaded.level, nullptr) << format("level", loaded.diagnostics.at(0));
  const Level& level = *loaded.level;
  const RealFace face(level.solid, level.faceSize);
  const auto towards = [&](double forward, double aside) {
    return nearest(forward * face.outwards(1) + aside * left(face.outwards(1)));
  };
  RandomSource random(properties::firstSeed());
  step_check::StepChecker checker(sceneOf(level, shape_));
  const auto step = [&](World& world, Point velocity, OpenElements open) {
    ElementRules rules(level, open);
    world.setRules(rules);
    Entity(world, 0).setVelocity(velocity);
    world.solve(&checker);
    world.resetRules();
    return checker.finishTick(open);
  };
  int crossings = 0;
  for (int round = 0; round < repetitions(5000); ++round) {
    World world = level.world;
    ElementRules open(level, {1});
    world.setRules(open);
    Entity ball(world, shape_);
    const auto between = [&](std::int64_t low, std::int64_t high) {
      return static_cast<double>(random.between(low, high));
    };
    const double far = between(3000, 30000);
    const double aside = between(-9000, 9000);
    MapPart(world, 0).insert(ball, nearest(face.middle(1)) + towards(-far, between(-300, 300) - aside),
                             Angle(static_cast<std::int32_t>(random.between(0, 35999))));
    ASSERT_EQ(step(world, towards(far - between(0, 3), aside), {1}), "");
    ASSERT_EQ(step(world, towards(between(1, 40), between(-40, 40)), {}), "")
        << "PLATON_SEED=" << properties::firstSeed() << ", round " << round;
    crossings += ball.part() == 5 ? 1 : 0;
  }
  EXPECT_GT(crossings, repetitions(800));
}

}  // namespace
}  // namespace platon::long_runs::elements_test
