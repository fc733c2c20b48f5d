#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "platon/game/game.h"
#include "platon/game/level.h"
#include "tests/levels/written_solution.h"
#include "tests/support/files.h"

namespace platon {
namespace {

std::string stemOf(const std::string& path) { return std::filesystem::path(path).stem().string(); }

class ShippedLevelTest : public testing::TestWithParam<std::string> {
 protected:
  std::string text() const { return readText(GetParam()); }
  std::shared_ptr<const Level> level() const { return loadLevel(text()).level; }
  std::vector<Input> solution() const { return readSolution("tests/levels/solutions/" + stemOf(GetParam()) + ".txt"); }
};

TEST_P(ShippedLevelTest, HasNoErrorsAndNoWarnings) {
  const LevelResult result = loadLevel(text());
  for (const Diagnostic& one : result.diagnostics) {
    ADD_FAILURE() << GetParam() << ":" << one.line << ":" << one.column << ": " << one.message;
  }
  ASSERT_NE(result.level, nullptr);
  EXPECT_FALSE(result.level->title.empty());
  EXPECT_FALSE(result.level->author.empty());
}

TEST_P(ShippedLevelTest, EveryFaceHas3To40Segments) {
  const auto level = this->level();
  ASSERT_NE(level, nullptr);
  for (std::size_t face = 0; face < level->segments.size(); ++face) {
    EXPECT_GE(level->segments[face].size(), 3u) << "face " << face;
    EXPECT_LE(level->segments[face].size(), 40u) << "face " << face;
  }
}

TEST_P(ShippedLevelTest, IsFinishedByItsSolution) {
  Game game(level());
  const std::vector<Input> inputs = solution();
  for (std::size_t tick = 0; tick < inputs.size(); ++tick) {
    ASSERT_FALSE(tick != 0 && game.player(0).finished()) << "already at tick " << tick << " of " << inputs.size();
    game.advance({&inputs[tick], 1});
  }
  EXPECT_TRUE(game.player(0).finished());
  EXPECT_TRUE(game.over());
  EXPECT_GT(game.ticksLeft(), 0u);
}

INSTANTIATE_TEST_SUITE_P(All, ShippedLevelTest, testing::ValuesIn(shippedLevels()),
                         [](const auto& spec) { return stemOf(spec.param); });

TEST(ShippedLevelsTest, EverySolidHasALevelAndTheFirstIsAHexahedron) {
  std::set<SolidKind> kinds;
  for (const std::string& name : shippedLevels()) kinds.insert(loadLevel(readText(name)).level->solid);
  EXPECT_EQ(kinds.size(), static_cast<std::size_t>(kSolidKinds));
  EXPECT_EQ(loadLevel(readText(shippedLevels().front())).level->solid, SolidKind::kHexahedron);
}

TEST(ShippedLevelsTest, EverySolutionHasItsLevel) {
  for (const auto& entry : std::filesystem::directory_iterator("tests/levels/solutions")) {
    const auto levels = shippedLevels();
    const std::string name = entry.path().stem().string();
    EXPECT_TRUE(std::any_of(levels.begin(), levels.end(), [&](const auto& level) { return stemOf(level) == name; }))
        << entry.path();
  }
}

}  // namespace
}  // namespace platon
