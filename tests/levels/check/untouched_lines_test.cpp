#include "levels/check/level_warnings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/shared/game/played_game.h"
#include "tests/sim/button_presses.h"
#include "tests/support/files.h"

namespace platon::untouched_lines_test {
namespace {

constexpr std::uint64_t kSeed = 3;

std::vector<int> untouched(const Level& level) {
  Diagnostics diagnostics;
  warnOfUntouchedLines(level, diagnostics);
  std::vector<int> lines;
  for (const Diagnostic& diagnostic : diagnostics.take()) lines.push_back(diagnostic.line);
  return lines;
}

const std::string kFloors = "-240 -200 240 -200";

std::vector<int> untouchedOn(const std::string& lines) {
  return untouched(*cubeLevel("0 0 -180 0", {kFloors + lines, kFloors, kFloors, kFloors}));
}

TEST(UntouchedLinesTest, WhatALineHidesIsNamed) {
  EXPECT_EQ(untouchedOn("\n-100 -230 100 -230"), std::vector<int>{7}) << "below the floor";
  EXPECT_EQ(untouchedOn("\n50 -150 150 -150\n150 -150 150 -80\n150 -80 50 -80\n50 -80 50 -150\n90 -115 110 -115"),
            std::vector<int>{11})
      << "in a box";
}

TEST(UntouchedGoalTest, AGoalInABoxOrBehindAShutDoorIsNamed) {
  const auto warnings = [](const std::string& lines) {
    Diagnostics diagnostics;
    warnOfUntouchedGoal(*cubeLevel("0 0 -180 0", {kFloors + lines, kFloors, kFloors, kFloors}, "0 100 -100"),
                        diagnostics);
    std::vector<std::string> texts;
    for (const Diagnostic& one : diagnostics.take()) texts.push_back(one.message);
    return texts;
  };
  const std::vector<std::string> named{"nobody can touch the goal, whatever is pressed: open a way to it"};
  const std::string sides = "\n50 -150 150 -150\n150 -150 150 -50\n150 -50 50 -50\n50 -50 50 -150";
  EXPECT_EQ(warnings(""), std::vector<std::string>());
  EXPECT_EQ(warnings(sides), named);
  EXPECT_EQ(warnings(sides + " door 1"), named) << "without a key";
  EXPECT_EQ(warnings(sides + " door 1\n95 -100 105 -100 key 1"), named) << "with its key behind it";
  EXPECT_EQ(warnings(sides + " door 1\n-60 -180 -40 -180 key 1\n0 -150 40 -150"), std::vector<std::string>());
}

TEST(UntouchedLinesTest, WhatIsTooHighToJumpToIsNamed) {
  EXPECT_EQ(untouchedOn("\n-50 60 50 60"), std::vector<int>{7});
  EXPECT_TRUE(untouchedOn("\n-50 -140 50 -140").empty());
  EXPECT_TRUE(untouchedOn("\n-50 60 50 60\n-200 -140 -100 -140\n-100 -80 0 -80\n-200 -20 -100 -20").empty())
      << "by steps";
}

// What a random player touches is not named.
TEST(UntouchedLinesTest, NoLineThatAPlayerTouchesIsNamed) {
  for (const std::string& file : solidLevels()) {
    const auto level = levelOf(readText(file));
    const std::vector<int> named = untouched(*level);
    for (std::uint32_t play = 0; play < 10 && !named.empty(); ++play) {
      Game game(level);
      sim::ButtonPresses presses(kSeed, play);
      for (int tick = 0; tick < 1500; ++tick) {
        const Input inputs[] = {presses.next()};
        game.advance(inputs);
        const EntityState& player = game.world().entities()[0];
        for (std::size_t i = 0; i < level->segments[player.part].size(); ++i) {
          const int line = level->positions[player.part][i].line;
          if (std::find(named.begin(), named.end(), line) == named.end()) continue;
          const Segment& segment = level->segments[player.part][i];
          const Point along = segment.b - segment.a;
          const Point from = player.position - segment.a;
          if (dot(from, along) < 0 || dot(player.position - segment.b, along) > 0) continue;
          const double apart = std::abs(static_cast<double>(cross(along, from))) / std::hypot(along.x, along.y);
          ASSERT_GT(apart, kPlayerApothem - 1) << file << ":" << line << ", seed " << kSeed << ", play " << play;
        }
      }
    }
  }
}

}  // namespace
}  // namespace platon::untouched_lines_test
