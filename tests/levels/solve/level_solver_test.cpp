#include "levels/solve/level_solver.h"

#include <gtest/gtest.h>

#include "tests/shared/game/played_game.h"

namespace platon::level_solver_test {
namespace {

const std::string kFlat = "-240 -200 240 -200\n";

// A level of this many players with these lines on its first face.
std::shared_ptr<const Level> levelFor(int players, const std::string& lines, const std::string& goal) {
  return levelOf("# players: " + std::to_string(players) + "\nHEXAHEDRON\n0 0 -180 0\n" + goal + "\n480\n%\n" + kFlat +
                 lines + "%\n%\n%\n%\n%\n");
}

TEST(LevelSolverTest, SolvesALevelAlone) {
  const auto level = levelFor(1, "", "0 100 -184");
  LevelSolver solver(level);
  const auto solution = solver.solve();
  ASSERT_TRUE(solution);
  EXPECT_TRUE(factsOf(level, *solution));
  EXPECT_GT(solver.states(), 0u);
}

TEST(LevelSolverTest, SaysThatItFoundNoWay) {
  const auto level = levelFor(1, "-200 -200 -200 -60\n200 -200 200 -60\n-200 -60 200 -60\n", "0 0 100");
  EXPECT_FALSE(LevelSolver(level).solve());
}

TEST(LevelSolverTest, AStoppedSearchFindsNothing) {
  for (const int players : {1, 2}) {
    LevelSolver solver(levelFor(players, "", "0 100 -184"));
    LevelSolver::Limits limits;
    int asked = 0;
    limits.stop = [&asked] { return ++asked > 0; };
    EXPECT_FALSE(solver.solve(limits));
    EXPECT_LE(asked, 2);
  }
}

// A player opens the door for the other one, which then opens another door from inside.
TEST(LevelSolverTest, TwoPlayersOpenDoorsForEachOther) {
  const std::string barred =
      "-60 -200 -60 -150\n-60 -150 150 -150\n150 -200 150 -150\n-50 -200 -20 -200 plate 1\n40 -200 40 -150 door 1\n";
  // The door needs a plate on the near side for the first player, and one behind it for the second.
  const auto open = levelFor(2, barred + "80 -200 110 -200 plate 1\n", "0 125 -184");
  LevelSolver solver(open);
  const auto solution = solver.solve();
  ASSERT_TRUE(solution);
  const auto facts = factsOf(open, *solution);
  ASSERT_TRUE(facts);
  EXPECT_EQ(facts->elements.size(), 2u) << "both plates";
  const auto closed = levelFor(2, barred, "0 125 -184");
  EXPECT_FALSE(LevelSolver(closed).solve()) << "who holds the door cannot pass it";
}

}  // namespace
}  // namespace platon::level_solver_test
