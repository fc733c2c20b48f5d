#include "client/demo/planner.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/test_level.h"

namespace platon::planner_test {
namespace {

// The game after a second of standing.
Game standingGame(const std::shared_ptr<const Level>& level) {
  Game game(level);
  const std::vector<Input> standing = {Input{Input::kPresent}};
  for (int tick = 0; tick < 60; ++tick) game.advance(standing);
  return game;
}

TEST(Planner, ThePlanReachesTheGoal) {
  for (const auto& level : {flatLevel(), cornerLevel()}) {
    GoalDistance distance(*level);
    const Game start = standingGame(level);
    Planner planner(start, 0, distance);
    while (planner.work(10000) == Planner::Status::kSearching) {
    }
    ASSERT_EQ(planner.status(), Planner::Status::kFound);
    Game game = start;
    for (const Input input : planner.plan()) {
      EXPECT_FALSE(game.player(0).finished());
      game.advance(std::vector<Input>{input});
    }
    EXPECT_TRUE(game.player(0).finished());
  }
}

TEST(Planner, ThePlanDoesNotDependOnTheStepSize) {
  const auto level = flatLevel();
  GoalDistance distance(*level);
  const Game start = standingGame(level);
  Planner small(start, 0, distance), large(start, 0, distance);
  while (small.work(1) == Planner::Status::kSearching) {
  }
  while (large.work(100000) == Planner::Status::kSearching) {
  }
  EXPECT_FALSE(small.plan().empty());
  EXPECT_EQ(small.plan(), large.plan());
}

}  // namespace
}  // namespace platon::planner_test
