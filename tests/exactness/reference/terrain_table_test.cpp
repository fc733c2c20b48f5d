#include "tests/exactness/reference/terrain_table.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace platon::reference::terrain_table_test {
namespace {

constexpr std::int64_t kTicks = 300;

Verdict verdict(Tie::Kind tie, std::int64_t firstAbove = 0) {
  Verdict result;
  result.inContact = true;
  result.tie.kind = tie;
  result.firstAbove = firstAbove;
  return result;
}

std::string summaryOf(const TerrainTable& table) {
  char* text = nullptr;
  std::size_t size = 0;
  std::FILE* file = open_memstream(&text, &size);
  table.printSummary(file);
  std::fclose(file);
  std::string result(text, size);
  std::free(text);
  return result;
}

TEST(TerrainTableTest, JudgesUntilEnoughScenesCount) {
  TerrainTable table(kTicks, nullptr);
  table.run(1, 5);
  EXPECT_EQ(table.counted(), 5);
}

TEST(TerrainTableTest, CountsNoSceneWithoutContactOrWithATieAtAJoint) {
  TerrainTable table(kTicks, nullptr);
  table.add({1, verdict(Tie::Kind::kNone)});
  table.add({2, verdict(Tie::Kind::kJoint)});
  table.add({3, verdict(Tie::Kind::kDivided)});
  table.add({4, Verdict()});
  EXPECT_EQ(table.counted(), 2);
  EXPECT_EQ(table.ties(), 1);
  EXPECT_TRUE(table.holds());
  const std::string expected =
      "2 scenes of 300 ticks, 1 of them with a tie or a narrow rest (0 narrow)\n"
      "not counted: 1 stopped at a joint, 1 without contact in the last 100 ticks\n";
  EXPECT_EQ(summaryOf(table).substr(0, expected.size()), expected);
}

TEST(TerrainTableTest, ASceneAboveTheLimitFails) {
  TerrainTable table(kTicks, nullptr);
  table.add({1, verdict(Tie::Kind::kNone)});
  EXPECT_TRUE(table.holds());
  Verdict above = verdict(Tie::Kind::kNone, 5);
  above.maxPrecise = 0.0011;
  table.add({17, above});
  EXPECT_FALSE(table.holds());
  EXPECT_EQ(table.above(), (std::vector<std::uint64_t>{17}));
  EXPECT_NE(summaryOf(table).find("position and remainder above 0.001024 subunits: 1 scenes\n"), std::string::npos);
  EXPECT_NE(summaryOf(table).find("lattice position above 2 subunits: 1 scenes 17\n"), std::string::npos);
}

TEST(TerrainTableTest, ANarrowRestCountsAsATie) {
  TerrainTable table(kTicks, nullptr);
  table.add({1, verdict(Tie::Kind::kNarrow)});
  table.add({2, verdict(Tie::Kind::kDivided)});
  EXPECT_EQ(table.ties(), 2);
  EXPECT_FALSE(table.holds());
}

TEST(TerrainTableTest, AtMostOnePercentOfTiesHolds) {
  TerrainTable table(kTicks, nullptr);
  for (std::uint64_t seed = 0; seed < 198; ++seed) table.add({seed, verdict(Tie::Kind::kNone)});
  for (std::uint64_t seed = 0; seed < 2; ++seed) table.add({seed, verdict(Tie::Kind::kDivided)});
  EXPECT_TRUE(table.holds());
  table.add({300, verdict(Tie::Kind::kDivided)});
  EXPECT_FALSE(table.holds());
}

}  // namespace
}  // namespace platon::reference::terrain_table_test
