#include "client/demo/stroll.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "platon/game/game.h"
#include "tests/support/files.h"
#include "tests/support/run/repetitions.h"
#include "tests/support/test_levels.h"

namespace platon::stroll_test {
namespace {

struct Walk {
  explicit Walk(const std::shared_ptr<const Level>& level) : game(level) {}

  void tick() {
    inputs.push_back(stroll.choose(game, 0));
    game.advance(std::array{inputs.back()});
    const EntityState& now = game.world().entities()[0];
    still = now.position == place.position && now.part == place.part ? still + 1 : 0;
    air = game.player(0).ground == Point() ? air + 1 : 0;
    place = now;
  }

  Game game;
  Stroll stroll;
  std::vector<Input> inputs;
  EntityState place;
  std::uint32_t still = 0;  // ticks
  std::uint32_t air = 0;
};

TEST(Stroll, KeepsRollingOnEveryLevelAndSolvesNone) {
  for (const std::string& file : shippedLevels()) {
    Walk walk(loadLevel(readText(file)).level);
    for (int tick = 0; tick < repetitions(6000); ++tick) {
      walk.tick();
      ASSERT_LT(walk.still, 200u) << file << ", tick " << tick;
      ASSERT_LE(walk.air, Stroll::kStepTicks + Stroll::kMaxSettleTicks) << file << ", tick " << tick;
      ASSERT_EQ(walk.game.player(0).arrived, 0) << file << ", tick " << tick;
    }
  }
}

TEST(Stroll, RollsOverTheEdgesOfTheFirstLevel) {
  Walk walk(loadLevel(readText(shippedLevels().front())).level);
  for (int tick = 0; tick < 1800; ++tick) walk.tick();
  EXPECT_GT(walk.place.crossings, 3u);
  const auto jumps = [](Input input) { return input.has(Input::kJump); };
  EXPECT_TRUE(std::any_of(walk.inputs.begin(), walk.inputs.end(), jumps));
}

TEST(Stroll, IsTheSameEachTime) {
  Walk first(flatLevel());
  Walk second(flatLevel());
  for (int tick = 0; tick < 1000; ++tick) {
    first.tick();
    second.tick();
  }
  EXPECT_EQ(first.inputs, second.inputs);
}

TEST(Stroll, ReturnsToTheStartFromAFallForEver) {
  Walk walk(loadLevel("HEXAHEDRON\n0 0 0 0\n4 200 200\n480\n%\n%\n%\n%\n%\n%\n").level);
  for (int tick = 0; tick < 1000; ++tick) walk.tick();
  const auto restarts = [](Input input) { return input.has(Input::kRestart); };
  EXPECT_EQ(std::count_if(walk.inputs.begin(), walk.inputs.end(), restarts), 3);
}

}  // namespace
}  // namespace platon::stroll_test
