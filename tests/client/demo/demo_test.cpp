#include "client/demo/demo.h"

#include <gtest/gtest.h>

#include <vector>

#include "client/demo/goal_distance.h"
#include "client/demo/planner.h"
#include "tests/support/test_level.h"

namespace platon {
namespace {

bool plays(Demo& demo, Game& game, std::uint32_t slot, int ticks) {
  std::vector<Input> inputs(slot + 1);
  inputs[slot] = {Input::kPresent};
  for (int tick = 0; tick < ticks; ++tick) {
    game.advance(inputs);
    if (game.player(slot).finished != 0) return true;
    inputs[slot].buttons = demo.choose(game, slot).buttons | Input::kPresent;
  }
  return false;
}

TEST(GoalDistance, IsZeroAtTheGoalAndGrowsWithTheWay) {
  const auto level = flatLevel();
  const GoalDistance distance(*level);
  const auto unit = kSubunitsPerUnit;
  EXPECT_LT(distance.from({level->goalFace, level->goal}), 20 * unit);
  const std::int32_t fromStart = distance.from({level->startFace, level->start});
  EXPECT_GT(fromStart, 300 * unit);
  EXPECT_LT(fromStart, 360 * unit);
}

TEST(GoalDistance, LeadsOverEdgesButNotThroughWalls) {
  const auto level = flatLevel();
  const GoalDistance distance(*level);
  for (const std::uint32_t face : {1u, 2u, 3u, 4u}) {
    const std::int32_t way = distance.from({face, Point(0, 0)});
    EXPECT_GT(way, 240 * kSubunitsPerUnit) << "face " << face;
    EXPECT_LT(way, 1200 * kSubunitsPerUnit) << "face " << face;
  }
  EXPECT_EQ(distance.from({5, Point(0, 0)}), GoalDistance::kUnreachable);
}

TEST(Planner, PlanLeadsToTheGoal) {
  for (const auto& level : {flatLevel(), cornerLevel()}) {
    const GoalDistance distance(*level);
    Game start(level);
    const std::vector<Input> standing = {Input{Input::kPresent}};
    for (int tick = 0; tick < 60; ++tick) start.advance(standing);
    Planner planner(start, 0, distance);
    while (planner.work(10000) == Planner::Status::kSearching) {
    }
    ASSERT_EQ(planner.status(), Planner::Status::kFound);
    Game game = start;
    for (const Input input : planner.plan()) {
      EXPECT_EQ(game.player(0).finished, 0);
      game.advance(std::vector<Input>{input});
    }
    EXPECT_EQ(game.player(0).finished, 1);
  }
}

TEST(Demo, FinishesALevel) {
  for (const auto& level : {flatLevel(), cornerLevel()}) {
    Demo demo;
    Game game(level);
    EXPECT_TRUE(plays(demo, game, 0, 3000));
  }
}

TEST(Demo, FinishesThoughItIsPushedOffItsWay) {
  Demo demo;
  Game game(cornerLevel());
  std::vector<Input> inputs = {Input{Input::kPresent}};
  game.advance(inputs);
  for (int tick = 0; tick < 6000 && game.player(0).finished == 0; ++tick) {
    game.advance(inputs);
    inputs[0].buttons = demo.choose(game, 0).buttons | Input::kPresent;
    if (tick % 150 < 3 && tick < 1000) inputs[0] = {Input::kPresent | Input::kLeft};
  }
  EXPECT_EQ(game.player(0).finished, 1);
}

TEST(Demo, PlaysTheNextRoundToo) {
  Demo demo;
  Game first(flatLevel());
  EXPECT_TRUE(plays(demo, first, 2, 3000));
  Game second(cornerLevel());
  EXPECT_TRUE(plays(demo, second, 2, 3000));
}

TEST(Demo, PressesNothingWhileAbsent) {
  Demo demo;
  const Game game(flatLevel());
  EXPECT_EQ(demo.choose(game, 0), Input{});
}

}  // namespace
}  // namespace platon
