#include "levels/reach/reach.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "tests/shared/game/played_game.h"
#include "tests/sim/button_presses.h"
#include "tests/support/files.h"
#include "tests/support/run/repetitions.h"

namespace platon::reach_test {
namespace {

constexpr std::uint64_t kSeed = 5;

const std::string kFlat = "-240 -200 240 -200\n";

std::optional<int> crossingsToGoal(const std::string& lines, const std::string& goal, int most = 2) {
  return Reach(*cubeLevel("0 0 -180 0", {kFlat + lines}, goal), most).crossingsToGoal();
}

TEST(ReachTest, AGoalOnTheFloorNeedsNoCrossing) { EXPECT_EQ(crossingsToGoal("", "0 100 -184"), 0); }

TEST(ReachTest, AGoalOutOfReachOfAJumpNeedsMore) {
  const std::string shelf = "80 -100 240 -100\n80 -100 80 -200\n";
  EXPECT_EQ(crossingsToGoal(shelf, "0 160 -84"), std::nullopt) << "100 units up, and no way round";
  const std::string step = "20 -150 60 -150\n";
  EXPECT_EQ(crossingsToGoal(shelf + step, "0 160 -84"), 0) << "a step on the way";
}

TEST(ReachTest, AGapTooWideToJumpIsNoWay) {
  const auto crossings = [](int right) {
    const auto level =
        cubeLevel("0 -200 0 0", {"-240 -20 -160 -20\n" + std::to_string(right) + " -20 240 -20"}, "0 220 -4");
    return Reach(*level, 0).crossingsToGoal();
  };
  EXPECT_EQ(crossings(-20), 0) << "140 units";
  EXPECT_EQ(crossings(80), std::nullopt) << "240 units";
}

// A line of a level text; `side` −1 mirrors it.
std::string lineOf(int side, int x0, int y0, int x1, int y1) {
  return std::to_string(side * x0) + " " + std::to_string(y0) + " " + std::to_string(side * x1) + " " +
         std::to_string(y1) + "\n";
}

// The ramp goes through the floor, on the left of the place where a player can stand or on its right. Nobody gets to
// an end of it.
TEST(ReachTest, ASlideDownASteepSegmentLeadsOverAWiderGap) {
  const auto crossings = [](int side, const std::string& ramp) {
    const std::string start = "0 " + std::to_string(side * -170) + " 0 0";
    const std::string goal = "0 " + std::to_string(side * 220) + " -4";
    const std::string sides = lineOf(side, -240, -20, -160, -20) + lineOf(side, 120, -20, 240, -20);
    return Reach(*cubeLevel(start, {sides + ramp}, goal), 0).crossingsToGoal();
  };
  EXPECT_EQ(crossings(1, ""), std::nullopt) << "280 units";
  EXPECT_EQ(crossings(1, lineOf(1, -190, 200, -190, -240)), std::nullopt) << "nobody slides down a wall";
  for (const int side : {1, -1}) EXPECT_EQ(crossings(side, lineOf(side, -215, 200, -161, -240)), 0) << side;
}

TEST(ReachTest, ACrossingIsCounted) {
  const auto level = cubeLevel("0 0 -180 0", {kFlat, kFlat, kFlat}, "2 0 -184");
  EXPECT_EQ(Reach(*level, 3).crossingsToGoal(), 2);
  EXPECT_EQ(Reach(*level, 1).crossingsToGoal(), std::nullopt);
}

TEST(ReachTest, ADoorIsNoWayWithoutItsKey) {
  const std::string room = "60 -200 60 -20 door 1\n60 -20 240 -20\n";
  EXPECT_EQ(crossingsToGoal(room, "0 160 -184", 0), std::nullopt);
  EXPECT_EQ(crossingsToGoal(room + "-100 -180 -100 -160 key 2", "0 160 -184", 0), std::nullopt);
  EXPECT_EQ(crossingsToGoal(room + "-100 -180 -100 -160 key 1", "0 160 -184", 0), 0);
}

TEST(ReachTest, AHazardIsNoGround) {
  const std::string pit = "-240 -20 -160 -20\n-160 -20 -160 -200\n100 -20 240 -20\n100 -20 100 -200\n";
  const auto crossings = [&](const std::string& floor) {
    return Reach(*cubeLevel("0 -200 0 0", {pit + "-160 -60 100 -60" + floor}, "0 220 -4"), 0).crossingsToGoal();
  };
  EXPECT_EQ(crossings(""), 0);
  EXPECT_EQ(crossings(" hazard"), std::nullopt);
}

// What random players do is possible.
class ReachLawTest : public testing::TestWithParam<std::string> {};

TEST_P(ReachLawTest, NobodyGetsFarther) {
  constexpr int kMost = hasSanitizers() ? 1 : 2;
  const auto level = levelOf(readText(GetParam()));
  const Reach reach(*level, kMost);
  std::mt19937_64 random(kSeed);
  for (std::uint32_t play = 0; play < repetitions(40u); ++play) {
    Game game(level);
    sim::ButtonPresses presses(kSeed, play);
    for (int tick = 0; tick < 1200; ++tick) {
      Input input = presses.next();
      if (random() % 40 == 0) input.buttons |= Input::kDown;
      const Input inputs[] = {validInput(input.buttons)};
      game.advance(inputs);
      const EntityState& player = game.world().entities()[0];
      // What needs more crossings than the goal is not searched.
      if (static_cast<int>(player.crossings) > kMost ||
          static_cast<int>(player.crossings) >= reach.crossingsToGoal().value_or(kMost + 1))
        break;
      const auto least = reach.crossingsTo(player.part, player.position, player.angle);
      ASSERT_TRUE(least && *least <= static_cast<int>(player.crossings))
          << "seed " << kSeed << ", play " << play << ", tick " << tick << ": face " << player.part << " at "
          << player.position.x / 1024 << " " << player.position.y / 1024;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, ReachLawTest, testing::ValuesIn(solidLevels()),
                         [](const testing::TestParamInfo<std::string>& test) {
                           return "Level" + std::to_string(test.index);
                         });

}  // namespace
}  // namespace platon::reach_test
