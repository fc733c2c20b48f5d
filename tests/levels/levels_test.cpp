// Each shipped level by itself, and all of them as a sequence.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "levels/check/level_warnings.h"
#include "levels/picture/level_picture.h"
#include "tests/levels/shipped_level.h"
#include "tests/sim/verify/verification.h"
#include "tests/support/files.h"

namespace platon::levels_test {
namespace {

// Fewest ticks for which the tightest jump of a level may be pressed.
constexpr int kLeastSlack = 5;

class ShippedLevelTest : public testing::TestWithParam<std::string> {};

TEST_P(ShippedLevelTest, HasNoErrorsAndNoWarnings) {
  const LevelResult result = loadLevel(readText(GetParam()));
  ASSERT_NE(result.level, nullptr) << GetParam();
  std::vector<Diagnostic> found = result.diagnostics;
  for (const Diagnostic& one : warningsOf(result.level)) found.push_back(one);
  for (const Diagnostic& one : found) ADD_FAILURE() << format(GetParam(), one);
}

TEST_P(ShippedLevelTest, StatesWhatItIs) {
  const auto level = loadLevel(readText(GetParam())).level;
  ASSERT_NE(level, nullptr) << GetParam();
  EXPECT_FALSE(level->title.empty());
  EXPECT_FALSE(level->author.empty());
  EXPECT_TRUE(level->crossings.has_value()) << "# crossings: N is missing";
}

// The recording says for each tick what the game was, so it also shows that the rules are as they were.
TEST_P(ShippedLevelTest, ItsRecordedWayReachesTheGoal) {
  const ShippedLevel shipped(GetParam());
  ASSERT_TRUE(shipped.isRecordedAsItIs()) << "run tests/levels/record.sh " << GetParam();
  const sim::Verification found = sim::Verifier(shipped.recording()).run();
  EXPECT_EQ(found.fault, "");
  EXPECT_FALSE(found.divergence);
  EXPECT_EQ(found.slots, shipped.level()->players);
  const auto facts = factsOf(shipped.level(), shipped.way());
  ASSERT_TRUE(facts) << "not all players are at the goal at the end";
  EXPECT_GE(facts->crossings, shipped.level()->crossings.value_or(0));
  EXPECT_GE(facts->slack.value_or(kLeastSlack), kLeastSlack) << "the tightest jump is too tight";
}

TEST_P(ShippedLevelTest, HasAPicture) {
  const auto level = loadLevel(readText(GetParam())).level;
  ASSERT_NE(level, nullptr) << GetParam();
  const Canvas picture = drawLevel(*level, 800);
  const std::vector<std::uint32_t> pixels = picture.pixels();
  const std::set<std::uint32_t> colours(pixels.begin(), pixels.end());
  EXPECT_GT(colours.size(), level->segments.size()) << "each face has a tint of its own";
  EXPECT_TRUE(std::filesystem::exists("docs/pictures/level_" + shippedName(GetParam()) + ".png"))
      << "run ./platon pictures";
}

INSTANTIATE_TEST_SUITE_P(All, ShippedLevelTest, testing::ValuesIn(shippedLevels()),
                         [](const auto& spec) { return shippedName(spec.param); });

std::vector<ShippedLevel> allLevels() {
  std::vector<ShippedLevel> all;
  for (const std::string& file : shippedLevels()) all.emplace_back(file);
  return all;
}

TEST(ShippedLevelsTest, AreNumberedInTheOrderOfTheRotation) {
  int number = 0;
  for (const std::string& file : shippedLevels()) {
    EXPECT_EQ(std::stoi(shippedName(file)), ++number) << file;
  }
}

TEST(ShippedLevelsTest, TheTableOfWaysHasTheirTimes) {
  std::string table =
      "# Ticks of the recorded easy way to the goal of each level, made by tests/levels/record.sh --times.\n";
  for (const ShippedLevel& shipped : allLevels()) {
    const auto facts = factsOf(shipped.level(), shipped.way());
    ASSERT_TRUE(facts) << shipped.name();
    table += shipped.name() + " " + std::to_string(facts->ticks) + "\n";
  }
  EXPECT_EQ(readText("levels/data/way_times"), table) << "run tests/levels/record.sh --times";
}

TEST(ShippedLevelsTest, AreEnoughOnEachSolidAndForTwoPlayers) {
  std::map<SolidKind, int> ofSolid;
  int forSeveral = 0;
  int needCrossings = 0;
  std::set<std::string> titles;
  for (const ShippedLevel& one : allLevels()) {
    ++ofSolid[one.level()->solid];
    forSeveral += one.level()->players >= 2 ? 1 : 0;
    needCrossings += one.level()->crossings.value_or(0) >= 1 ? 1 : 0;
    EXPECT_TRUE(titles.insert(one.level()->title).second) << one.name() << " has the title of another level";
  }
  ASSERT_EQ(ofSolid.size(), static_cast<std::size_t>(kSolidKinds));
  for (const auto& [solid, count] : ofSolid) EXPECT_GE(count, 6) << nameOf(solid);
  EXPECT_GE(forSeveral, 6);
  EXPECT_GE(needCrossings, 24);
}

// The levels in levels/data/drawn are in the order in which they were drawn in the editor.
TEST(ShippedLevelsTest, GetHarderOnEachSolid) {
  std::map<SolidKind, std::pair<int, std::string>> hardest;
  for (const std::string& file : shippedLevels()) {
    if (std::filesystem::path(file).parent_path().filename() == "drawn") continue;
    const ShippedLevel one(file);
    const auto facts = factsOf(one.level(), one.way());
    ASSERT_TRUE(facts) << one.name();
    const int difficulty = difficultyOf(*facts);
    auto& [most, name] = hardest[one.level()->solid];
    EXPECT_GT(difficulty, most) << one.name() << " after " << name;
    most = difficulty;
    name = one.name();
  }
}

TEST(ShippedLevelsTest, EachRecordingHasItsLevel) {
  std::set<std::string> names;
  for (const std::string& file : shippedLevels()) names.insert(shippedName(file));
  for (const std::string& file : filesIn("levels/data/ways", ".recording")) {
    EXPECT_TRUE(names.contains(shippedName(file))) << file;
  }
}

}  // namespace
}  // namespace platon::levels_test
