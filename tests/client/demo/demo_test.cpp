#include "client/demo/demo.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/test_level.h"

namespace platon {
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
}  // namespace platon
