#include "tests/exactness/reference/solid_walk.h"

#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "platon/game/solid.h"
#include "tests/exactness/step_check/run_length.h"
#include "tests/shared/game/real_face.h"

namespace platon::reference {
namespace {

class SolidWalkTest : public testing::TestWithParam<std::tuple<SolidKind, Drive>> {};

/// I8 over edges.
TEST_P(SolidWalkTest, TheBodyFollowsItsIdealPath) {
  const auto [kind, drive] = GetParam();
  const std::int64_t walks = step_check::runLength(4, 10);
  std::int64_t contacts = 0;
  std::int64_t crossings = 0;
  for (std::int64_t seed = 1; seed <= walks; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const WalkVerdict walk = judgeWalk(kind, drive, static_cast<std::uint64_t>(seed), 1000);
    EXPECT_LE(walk.maxLattice, 2);
    EXPECT_LE(walk.maxOverEdges, 4);
    EXPECT_LE(walk.maxPrecise, 0.05);
    contacts += walk.contactTicks;
    crossings += walk.crossings;
  }
  EXPECT_GT(contacts, 50 * walks);
  EXPECT_GT(crossings, 0);
}

std::string nameOfWalk(const testing::TestParamInfo<std::tuple<SolidKind, Drive>>& walk) {
  return std::string(nameOf(std::get<0>(walk.param))) + (std::get<1>(walk.param) == Drive::kPush ? "Push" : "Gravity");
}

INSTANTIATE_TEST_SUITE_P(Solids, SolidWalkTest,
                         testing::Combine(testing::ValuesIn(kAllSolids),
                                          testing::Values(Drive::kPush, Drive::kGravity)),
                         nameOfWalk);

}  // namespace
}  // namespace platon::reference
