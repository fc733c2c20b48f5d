#include "levels/solve/solution.h"

#include <gtest/gtest.h>

#include "tests/shared/game/played_game.h"

namespace platon::solution_test {
namespace {

const std::string kFlat = "-240 -200 240 -200\n";

// Plays a script of `ticks buttons` and then holds the last buttons until the goal.
Solution scripted(const std::shared_ptr<const Level>& level, std::vector<std::pair<int, int>> script) {
  Solution solution;
  Game game(level);
  for (std::size_t step = 0; !game.over() && solution.size() < 600;) {
    const Input input{static_cast<std::uint8_t>(script[step].second | Input::kPresent)};
    solution.push_back({input});
    game.advance({&input, 1});
    if (--script[step].first == 0 && step + 1 < script.size()) ++step;
  }
  return solution;
}

TEST(SolutionTest, CountsTicksPressesAndCrossings) {
  const auto level = cubeLevel("0 0 -180 0", {kFlat, kFlat}, "1 0 -184");
  const Solution solution =
      scripted(level, {{20, 0}, {10, Input::kRight}, {5, Input::kRight | Input::kJump}, {1, Input::kRight}});
  const auto facts = factsOf(level, solution);
  ASSERT_TRUE(facts);
  EXPECT_EQ(facts->presses, 2u);
  EXPECT_EQ(facts->crossings, 1u);
  EXPECT_EQ(facts->turns, 0u);
  EXPECT_EQ(facts->ticks, solution.size() - 20);
}

TEST(SolutionTest, IsRefusedWhenItDoesNotEndAtTheGoal) {
  const auto level = cubeLevel("0 0 -180 0", {kFlat}, "0 100 -184");
  Solution solution = scripted(level, {{1, Input::kRight}});
  ASSERT_TRUE(factsOf(level, solution));
  Solution longer = solution;
  longer.push_back({Input{Input::kPresent}});
  EXPECT_FALSE(factsOf(level, longer));
  solution.pop_back();
  EXPECT_FALSE(factsOf(level, solution));
  EXPECT_FALSE(factsOf(level, {}));
}

TEST(SolutionTest, IsHarderWithMorePressesTurnsAndATighterJump) {
  SolutionFacts facts;
  facts.presses = 5;
  facts.turns = 2;
  EXPECT_EQ(difficultyOf(facts), 13);
  facts.slack = 12;
  EXPECT_EQ(difficultyOf(facts), 13);
  facts.slack = 3;
  EXPECT_EQ(difficultyOf(facts), 22);
}

TEST(SolutionTest, NamesTheElementsThatWereTouched) {
  const auto level =
      cubeLevel("0 0 -180 0", {kFlat + "40 -180 40 -160 key 3\n60 -180 60 -160 checkpoint\n-90 -200 -60 -200 plate 1"},
                "0 130 -184");
  const auto facts = factsOf(level, scripted(level, {{1, Input::kRight}}));
  ASSERT_TRUE(facts);
  std::set<ElementKind> kinds;
  for (const std::uint32_t index : facts->elements) kinds.insert(level->elements[index].kind);
  EXPECT_EQ(kinds, (std::set<ElementKind>{ElementKind::kKey, ElementKind::kCheckpoint}));
}

}  // namespace
}  // namespace platon::solution_test
