#include "client/lobby/shipped_levels.h"

#include <algorithm>
#include <cstdio>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "platon/game/game.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::shipped_levels_test {
namespace {

TEST(ShippedLevels, TheLevelsOfASolidFollowEachOther) {
  std::set<std::string> done;
  std::string solid;
  for (const LevelEntry& entry : entriesOf(loadShippedLevels(), "", ReachedLevels({}))) {
    const bool begins = entry.solid != solid;
    EXPECT_TRUE(!begins || done.insert(entry.solid).second) << entry.title;
    solid = entry.solid;
    EXPECT_FALSE(entry.title.empty());
    EXPECT_GE(entry.players, 1U);
    EXPECT_FALSE(entry.bestTicks);
    EXPECT_TRUE(entry.medals) << "run tests/levels/record.sh --times";
  }
  EXPECT_EQ(done.size(), std::size_t{kSolidKinds});
}

TEST(ShippedLevels, HaveTheBestTimesOfThePresentRules) {
  const std::vector<ShippedLevel> levels = loadShippedLevels();
  char hash[17];
  std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(levels[2].level->hash));
  const TemporaryFolder folder;
  const std::string file = folder / "best_times";
  writeText(file, std::string(hash) + " " + std::to_string(kRulesVersion) + " 90 2026-12-01T18:00:00Z Ann\n");
  const std::vector<LevelEntry> entries = entriesOf(levels, file, ReachedLevels({}));
  EXPECT_EQ(entries[2].bestTicks, 90U);
  EXPECT_TRUE(entries[2].reached) << "by a program that kept times alone";
  EXPECT_FALSE(entries[1].bestTicks);
  writeText(file, "damaged\n");
  EXPECT_FALSE(entriesOf(levels, file, ReachedLevels({}))[2].bestTicks);
}

TEST(ShippedLevels, TellTheTimesOfOlderRulesApart) {
  const std::vector<ShippedLevel> levels = loadShippedLevels();
  const auto lineOf = [&](std::size_t level, std::uint32_t rules, int ticks) {
    char hash[17];
    std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(levels[level].level->hash));
    return std::string(hash) + " " + std::to_string(rules) + " " + std::to_string(ticks) +
           " 2026-12-01T18:00:00Z Ann\n";
  };
  const TemporaryFolder folder;
  const std::string file = folder / "best_times";
  writeText(file, lineOf(0, kRulesVersion, 90) + lineOf(1, kRulesVersion - 1, 80) + lineOf(1, kRulesVersion - 2, 70));
  const std::vector<LevelEntry> entries = entriesOf(levels, file, ReachedLevels({}));
  EXPECT_FALSE(entries[0].olderTicks);
  EXPECT_FALSE(entries[1].bestTicks);
  EXPECT_EQ(entries[1].olderTicks, 80U) << "of the newest ones of them";
  EXPECT_FALSE(entries[1].reached);
  EXPECT_FALSE(entries[2].olderTicks);
}

TEST(ShippedLevels, AreReachedWithATimeOrWithoutOne) {
  const std::vector<ShippedLevel> levels = loadShippedLevels();
  const TemporaryFolder folder;
  ReachedLevels reached(folder / "reached");
  reached.add(levels[1].level->hash);
  const std::vector<LevelEntry> entries = entriesOf(levels, "", reached);
  EXPECT_FALSE(entries[0].reached);
  EXPECT_TRUE(entries[1].reached);
  EXPECT_FALSE(entries[1].bestTicks);
}

TEST(ShippedLevels, HaveRecordedWaysAndOtherLevelsHaveNone) {
  for (const ShippedLevel& one : loadShippedLevels()) {
    const std::optional<Solution> way = shippedWay(*one.level);
    ASSERT_TRUE(way) << "run tests/levels/record.sh " << one.file;
    EXPECT_TRUE(factsOf(one.level, *way)) << one.file;
    const LevelResult changed = loadLevel(one.level->text + "# changed\n");
    EXPECT_FALSE(shippedWay(*changed.level)) << one.file;
  }
}

TEST(ShippedLevels, TheTimesOfWaysAreReadFromTheirTable) {
  const auto times = parseWayTimes("# comment 1\n01_one 228\n\n02_two\n03_three 0x\n04_four 7 more\n");
  EXPECT_EQ(times, (std::map<std::string, std::uint32_t>{{"01_one", 228}, {"03_three", 0}, {"04_four", 7}}));
}

}  // namespace
}  // namespace platon::shipped_levels_test
