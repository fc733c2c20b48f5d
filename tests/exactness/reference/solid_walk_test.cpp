#include "tests/exactness/reference/solid_walk.h"

#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "platon/game/solid.h"
#include "tests/shared/game/real_face.h"
#include "tests/support/run/repetitions.h"

namespace platon::reference::solid_walk_test {
namespace {

class SolidWalkTest : public testing::TestWithParam<std::tuple<SolidKind, Drive>> {};

/// I8 over edges.
TEST_P(SolidWalkTest, TheBodyFollowsItsIdealPath) {
  const auto [kind, drive] = GetParam();
  const std::int64_t walks = repetitions(20);
  std::int64_t contacts = 0;
  std::int64_t crossings = 0;
  for (std::int64_t seed = 1; seed <= walks; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const WalkVerdict walk = judgeWalk(kind, drive, static_cast<std::uint64_t>(seed), 1000);
    EXPECT_LE(walk.maxLattice, 2);
    EXPECT_LE(walk.maxOverEdges, 3);
    EXPECT_LE(walk.maxPrecise, 0.05);
    contacts += walk.contactTicks;
    crossings += walk.crossings;
  }
  EXPECT_GT(contacts, 50 * walks);
  EXPECT_GT(crossings, 0);
}

/// Where the posts of three faces meet, instances that are off by a subunit leave no way to the ideal place.
TEST(SolidWalkCaseTest, TheBodyGoesRoundTheCornerOfASolid) {
  const WalkVerdict walk = judgeWalk(SolidKind::kIcosahedron, Drive::kGravity, 11, 300);
  EXPECT_GT(walk.judgedTicks, 229);
  EXPECT_LE(walk.maxOverEdges, 2);
  EXPECT_LE(walk.maxPrecise, 0.05);
}

/// In tick 347, the body meets a wall of the face that it leaves at the very end of the wall's edge.
TEST(SolidWalkCaseTest, TheBodyPassesTheEndOfAWallOfTheFaceThatItLeaves) {
  const WalkVerdict walk = judgeWalk(SolidKind::kTetrahedron, Drive::kPush, 100, 360);
  EXPECT_EQ(walk.judgedTicks, 360);
  EXPECT_LE(walk.maxLattice, 2);
  EXPECT_LE(walk.maxPrecise, 0.05);
}

/// The ideal body goes on for hundreds of subunits where the lattice has no free place.
TEST(SolidWalkCaseTest, TheJudgementEndsInANarrowWedge) {
  const WalkVerdict walk = judgeWalk(SolidKind::kIcosahedron, Drive::kPush, 40, 1000);
  EXPECT_EQ(walk.end, WalkEnd::kNarrow);
  EXPECT_EQ(walk.judgedTicks, 140);
  EXPECT_LE(walk.maxLattice, 2);
}

std::string nameOfWalk(const testing::TestParamInfo<std::tuple<SolidKind, Drive>>& walk) {
  return std::string(nameOf(std::get<0>(walk.param))) + (std::get<1>(walk.param) == Drive::kPush ? "Push" : "Gravity");
}

INSTANTIATE_TEST_SUITE_P(Solids, SolidWalkTest,
                         testing::Combine(testing::ValuesIn(kAllSolids),
                                          testing::Values(Drive::kPush, Drive::kGravity)),
                         nameOfWalk);

}  // namespace
}  // namespace platon::reference::solid_walk_test
