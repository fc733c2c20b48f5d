#include "client/demo/demo.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/test_level.h"

namespace platon::demo_test {
namespace {

// Returns whether the player finishes within this number of ticks.
bool finishes(Demo& demo, Game& game, std::uint32_t slot, int ticks) {
  std::vector<Input> inputs(slot + 1);
  inputs[slot] = {Input::kPresent};
  for (int tick = 0; tick < ticks; ++tick) {
    game.advance(inputs);
    if (game.player(slot).finished()) return true;
    inputs[slot].buttons = demo.choose(game, slot).buttons | Input::kPresent;
  }
  return false;
}

TEST(Demo, FinishesALevel) {
  for (const auto& level : {flatLevel(), cornerLevel()}) {
    Demo demo;
    Game game(level);
    EXPECT_TRUE(finishes(demo, game, 0, 3000));
  }
}

// Over a hazard and through a one-way segment to the goal behind a door, with the key on the other side of the start.
TEST(Demo, FinishesALevelWithElements) {
  const LevelResult result = loadLevel(
      "HEXAHEDRON\n0 -100 -180 0\n0 180 -180\n480\n%\n"
      "-220 -200 220 -200\n220 -200 220 -80\n220 -80 -220 -80\n-220 -80 -220 -200\n"
      "-30 -200 -20 -190 hazard\n-20 -190 -10 -200 hazard\n40 -80 40 -200 oneway\n70 -200 70 -150 checkpoint\n"
      "-200 -180 -200 -160 key 3\n120 -200 120 -80 door 3\n0 -120 30 -120 up 0\n%\n%\n%\n%\n%\n");
  ASSERT_TRUE(result.level) << result.diagnostics.front().message;
  Demo demo;
  Game game(result.level);
  EXPECT_TRUE(finishes(demo, game, 0, 3000));
  EXPECT_EQ(game.openDoors(), 1u << 3);
  EXPECT_EQ(game.player(0).checkpoint, 4) << "the fourth element";
}

TEST(Demo, FinishesAlthoughItIsPushedOffItsPath) {
  Demo demo;
  Game game(cornerLevel());
  std::vector<Input> inputs = {Input{Input::kPresent}};
  game.advance(inputs);
  for (int tick = 0; tick < 6000 && !game.player(0).finished(); ++tick) {
    game.advance(inputs);
    inputs[0].buttons = demo.choose(game, 0).buttons | Input::kPresent;
    if (tick % 150 < 3 && tick < 1000) inputs[0] = {Input::kPresent | Input::kLeft};
  }
  EXPECT_TRUE(game.player(0).finished());
}

TEST(Demo, PlaysTheNextRound) {
  Demo demo;
  Game first(flatLevel());
  EXPECT_TRUE(finishes(demo, first, 2, 3000));
  Game second(cornerLevel());
  EXPECT_TRUE(finishes(demo, second, 2, 3000));
}

TEST(Demo, PressesNothingWhileAbsent) {
  Demo demo;
  const Game game(flatLevel());
  EXPECT_EQ(demo.choose(game, 0), Input{});
}

}  // namespace
}  // namespace platon::demo_test
