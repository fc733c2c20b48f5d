#include "client/editor/new_level.h"

#include <gtest/gtest.h>

#include "levels/solve/level_solver.h"
#include "platon/game/level.h"

namespace platon::new_level_test {
namespace {

TEST(NewLevelTest, ANewLevelIsValidWithoutWarningsAndSolved) {
  for (int kind = 0; kind < kSolidKinds; ++kind) {
    const auto solid = static_cast<SolidKind>(kind);
    const LevelResult result = loadLevel(newLevelText(solid, "My level"));
    ASSERT_TRUE(result.level) << result.diagnostics.front().message;
    EXPECT_TRUE(result.diagnostics.empty());
    EXPECT_EQ(result.level->solid, solid);
    EXPECT_EQ(result.level->title, "My level");
    EXPECT_TRUE(LevelSolver(result.level).solve());
  }
}

TEST(NewLevelTest, TheTitleIsMadeOfTheFileName) {
  EXPECT_EQ(titleOf("02_half_turn.level"), "Half turn");
  EXPECT_EQ(titleOf("room"), "Room");
  EXPECT_EQ(titleOf("07.level"), "New level");
  EXPECT_EQ(titleOf("\xff\n.level"), "New level");
}

}  // namespace
}  // namespace platon::new_level_test
