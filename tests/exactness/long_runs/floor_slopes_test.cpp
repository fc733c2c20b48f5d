// I3 on floors that cross every edge of every solid, at all slopes and in both directions.
#include <gtest/gtest.h>

#include "platon/game/solid.h"
#include "tests/exactness/step_check/run_length.h"
#include "tests/shared/game/edge_floor.h"

namespace platon::long_runs::floor_slopes_test {
namespace {

class FloorSlopesTest : public testing::TestWithParam<SolidKind> {};

// On steeper floors the centre of the ball, which is above the floor, crosses the edge only after the end of this run.
TEST_P(FloorSlopesTest, CrossingAnEdgeNeitherSlowsNorLifts) {
  const PlatonicSolid& solid = PlatonicSolid::of(GetParam());
  const auto step = static_cast<int>(step_check::stride(5));
  for (int face = 0; face < solid.faces(); ++face) {
    for (int edge = 0; edge < solid.edgesPerFace(); ++edge) {
      for (int slant = -60; slant <= 60; slant += step) {
        const Floor floor{GetParam(), face, edge, 0.5, static_cast<double>(slant)};
        ASSERT_NO_FATAL_FAILURE(expectSmooth(floor, alignedWith(floor), 256));
        ASSERT_NO_FATAL_FAILURE(expectSmooth(floor, alignedWith(floor) + Angle::degrees(180), 60));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Solids, FloorSlopesTest, testing::ValuesIn(kAllSolids),
                         [](const auto& described) { return std::string(nameOf(described.param)); });

}  // namespace
}  // namespace platon::long_runs::floor_slopes_test
