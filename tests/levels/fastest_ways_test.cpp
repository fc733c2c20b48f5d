// That nobody has opened a shorter way through a shipped level: the fastest way that a search finds takes nearly as
// long as the recorded one. Crossings say nothing about doors and walls.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "levels/solve/level_solver.h"
#include "tests/levels/shipped_level.h"
#include "tests/support/files.h"
#include "tests/support/run/repetitions.h"

namespace platon::fastest_ways_test {
namespace {

constexpr double kLeastShare = 0.8;

// Ticks of the fastest way that is found, as a share of those of the recorded way.
double shareOf(const std::shared_ptr<const Level>& level, const ShippedLevel& shipped) {
  const auto way = LevelSolver(level).solve();
  return way ? static_cast<double>(way->size()) / static_cast<double>(shipped.way().size()) : 0;
}

class FastestWayTest : public testing::TestWithParam<std::string> {};

TEST_P(FastestWayTest, TakesNearlyAsLongAsTheRecordedOne) {
  if (isBrief()) GTEST_SKIP() << "a brief run";
  const ShippedLevel shipped(GetParam());
  EXPECT_GE(shareOf(shipped.level(), shipped), kLeastShare) << "see platon-level solve " << GetParam();
}

INSTANTIATE_TEST_SUITE_P(All, FastestWayTest, testing::ValuesIn(shippedLevels()),
                         [](const auto& spec) { return shippedName(spec.param); });

// These levels still need their crossings.
TEST(ShortenedLevelTest, IsFound) {
  struct Case {
    std::string file;
    std::string end;  // of the line that is left out
  };
  const std::vector<Case> cases = {
      {"levels/data/tetrahedron/11_the_order_of_corners.level", " door 1"},
      {"levels/data/icosahedron/30_four_downs.level", " door 1"},
      {"levels/data/octahedron/13_third_of_a_turn.level", "-64.3162 -151.8431 57.5129 59.171"}};
  for (const Case& each : cases) {
    const ShippedLevel shipped(each.file);
    const auto shortened =
        changed(*shipped.level(), [&](int, const std::string& line) { return line.ends_with(each.end) ? "" : line; });
    ASSERT_TRUE(shortened) << each.file;
    EXPECT_LT(shareOf(shortened, shipped), kLeastShare) << each.file << " without " << each.end;
  }
}

}  // namespace
}  // namespace platon::fastest_ways_test
