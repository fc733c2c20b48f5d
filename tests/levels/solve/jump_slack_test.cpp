#include "levels/solve/solution.h"

#include <gtest/gtest.h>

#include "tests/shared/game/played_game.h"

namespace platon::jump_slack_test {
namespace {

// Runs to the right over a gap of this width, and jumps this far before it.
std::optional<int> slackOver(int gap, int before) {
  const auto level =
      cubeLevel("0 -220 0 0", {"-240 -20 -100 -20\n" + std::to_string(gap - 100) + " -20 240 -20"}, "0 230 -4");
  Solution solution;
  Game game(level);
  while (!game.over() && solution.size() < 400) {
    const bool isOnGround = game.slots() > 0 && game.player(0).ground != Point();
    const bool jumps = game.slots() > 0 && game.world().entities()[0].position.x > units(-100 - before) &&
                       (!isOnGround || game.world().entities()[0].position.x < units(-90));
    const bool starts = solution.size() > 30;
    const int buttons = (starts ? Input::kRight : 0) | (jumps ? Input::kJump : 0);
    const Input input{static_cast<std::uint8_t>(buttons | Input::kPresent)};
    solution.push_back({input});
    game.advance({&input, 1});
  }
  EXPECT_TRUE(factsOf(level, solution));
  return tightestJump(level, solution);
}

TEST(JumpSlackTest, AWiderGapIsTighter) {
  const auto wide = slackOver(145, 8);
  const auto narrow = slackOver(60, 30);
  ASSERT_TRUE(wide);
  ASSERT_TRUE(narrow);
  EXPECT_LT(*wide, *narrow);
  EXPECT_GE(*wide, 1);
  EXPECT_LE(*wide, 14);
  EXPECT_GE(*narrow, 15);
}

TEST(JumpSlackTest, ASolutionWithoutAJumpHasNone) {
  const auto level = cubeLevel("0 0 -180 0", {"-240 -200 240 -200"}, "0 100 -184");
  Solution solution;
  Game game(level);
  while (!game.over()) {
    solution.push_back({Input{Input::kPresent | Input::kRight}});
    game.advance(solution.back());
  }
  EXPECT_EQ(tightestJump(level, solution), std::nullopt);
}

}  // namespace
}  // namespace platon::jump_slack_test
