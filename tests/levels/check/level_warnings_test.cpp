#include "levels/check/level_warnings.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/shared/game/played_game.h"

namespace platon::level_warnings_test {
namespace {

std::vector<std::string> warnings(const std::string& lines, const std::string& goal = "0 100 -160") {
  std::vector<std::string> texts;
  for (const Diagnostic& diagnostic : warningsOf(cubeLevel("0 0 -180 0", {lines}, goal))) {
    EXPECT_FALSE(diagnostic.error);
    texts.push_back(std::to_string(diagnostic.line) + ":" + std::to_string(diagnostic.column) + ": " +
                    diagnostic.message);
  }
  return texts;
}

TEST(LevelWarningsTest, AGoodLevelHasNone) { EXPECT_EQ(warnings("-240 -200 240 -200"), std::vector<std::string>()); }

TEST(LevelWarningsTest, AStartWithoutGroundIsNamed) {
  EXPECT_EQ(warnings(""),
            std::vector<std::string>{"2:3: the player falls for ever from the start: put a line below it"});
}

TEST(LevelWarningsTest, AFallIntoTheGoalIsFine) { EXPECT_EQ(warnings("", "0 0 -220"), std::vector<std::string>()); }

TEST(LevelWarningsTest, AGoalAtAWallIsNamed) {
  EXPECT_EQ(
      warnings("-240 -200 240 -200", "0 100 -184.2"),
      std::vector<std::string>{"3:3: the goal's disc, of radius 16, is at the line of text line 6: move it away, or "
                               "it may be touched through the line"});
  EXPECT_EQ(warnings("-240 -200 240 -200", "0 100 -183"), std::vector<std::string>());
  EXPECT_EQ(warnings("-240 -200 240 -200\n90 -170 110 -170 key 1", "0 100 -170"), std::vector<std::string>())
      << "a key does not block";
}

TEST(LevelWarningsTest, AreInTheOrderOfTheText) {
  const auto all =
      warnings("-240 -200 240 -200\n-100 -240 100 -220\n-50 -180 -50 -140\n-27 -180 -27 -140", "0 100 -184");
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(all[0].substr(0, 3), "3:3");
  EXPECT_EQ(all[1].substr(0, 3), "7:1");
}

}  // namespace
}  // namespace platon::level_warnings_test
