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
  EXPECT_EQ(warnings("-240 -200 240 -200", "0 100 -184.2"),
            std::vector<std::string>{"3:3: the goal's disc, of radius 16, is too close to line 6: move it away, or "
                                     "players may touch it through the line"});
  EXPECT_EQ(warnings("-240 -200 240 -200", "0 100 -183"), std::vector<std::string>());
  EXPECT_EQ(warnings("-240 -200 240 -200\n90 -170 110 -170 key 1", "0 100 -170"), std::vector<std::string>())
      << "a key does not block";
}

TEST(LevelWarningsTest, ADoorThatNothingOpensIsNamed) {
  const std::string doors = "-240 -200 240 -200\n-200 -200 -200 -140 door 2\n-150 -200 -150 -140 door 2\n";
  const std::string warning = "7:1: door 2 never opens: draw a key 2 or a plate 2, or make it a wall";
  EXPECT_EQ(warnings(doors), std::vector<std::string>{warning});
  EXPECT_EQ(warnings(doors + "50 -180 60 -180 key 1"), std::vector<std::string>{warning});
  EXPECT_EQ(warnings(doors + "50 -180 60 -180 key 2"), std::vector<std::string>());
  EXPECT_EQ(warnings(doors + "20 -200 60 -200 plate 2"), std::vector<std::string>());
}

TEST(LevelWarningsTest, ANeedThatTheLevelLacksIsNamed) {
  const auto warnings = [](const std::string& lines) {
    std::vector<std::string> texts;
    const auto level =
        levelOf("# needs: key 1, checkpoint\nHEXAHEDRON\n0 0 -180 0\n0 100 -160\n480\n%\n-240 -200 240 -200\n" + lines +
                "%\n%\n%\n%\n%\n");
    for (const Diagnostic& one : warningsOf(level)) texts.push_back(std::to_string(one.line) + ": " + one.message);
    return texts;
  };
  EXPECT_EQ(warnings("40 -180 60 -180 checkpoint\n50 -170 60 -170 key 1\n"), std::vector<std::string>());
  EXPECT_EQ(
      warnings("50 -170 60 -170 key 1\n"),
      std::vector<std::string>{"1: 'needs:' names checkpoint, which the level lacks: draw it, or do not name it"});
  EXPECT_EQ(warnings("50 -170 60 -170 key 2\n").size(), 2u);
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
