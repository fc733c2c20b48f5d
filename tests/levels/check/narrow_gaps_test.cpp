#include "levels/check/level_warnings.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/shared/game/played_game.h"

namespace platon::narrow_gaps_test {
namespace {

std::vector<Diagnostic> gaps(const std::string& lines) {
  Diagnostics diagnostics;
  warnOfNarrowGaps(*cubeLevel("0 0 -180 0", {lines}), diagnostics);
  return diagnostics.take();
}

std::string corridor(const std::string& width) { return "50 0 50 100\n" + width + " 0 " + width + " 100\n"; }

TEST(NarrowGapsTest, AGapThatIsLittleTooNarrowIsNamedOnce) {
  const auto found = gaps(corridor("73.5"));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].line, 7);
  EXPECT_FALSE(found[0].error);
  EXPECT_EQ(
      found[0].message,
      "the gap to line 6 is 23.50 units wide, and the ball needs 24.01: make it wider, or narrower than 18 to show "
      "that it is closed");
}

TEST(NarrowGapsTest, WideAndClosedGapsAreFine) {
  EXPECT_TRUE(gaps(corridor("74.1")).empty());
  EXPECT_TRUE(gaps(corridor("67")).empty());
}

TEST(NarrowGapsTest, TheWidthOfTheBallAnd3SubunitsIsTheLimit) {
  EXPECT_EQ(gaps(corridor("74")).size(), 1u);
  EXPECT_EQ(gaps(corridor("74.002")).size(), 1u) << "2 subunits more";
  EXPECT_TRUE(gaps(corridor("74.0039")).empty()) << "4 subunits more";
}

TEST(NarrowGapsTest, AStepIsNoGap) { EXPECT_TRUE(gaps("0 0 50 0\n50 0 50 20\n50 20 100 20").empty()); }

TEST(NarrowGapsTest, KeysAndCheckpointsMakeNoGap) {
  EXPECT_TRUE(gaps("50 0 50 100\n70 0 70 100 key 1\n30 0 30 100 checkpoint").empty());
}

}  // namespace
}  // namespace platon::narrow_gaps_test
