#include "platon/physics/unfold.h"

#include <gtest/gtest.h>

#include "tests/support/test_levels.h"

namespace platon::unfold_test {
namespace {

constexpr std::int32_t kUnit = kSubunitsPerUnit;

class UnfoldTest : public testing::Test {
 protected:
  const std::shared_ptr<const Level> level_ = flatLevel();
  const Geometry& geometry_ = level_->world.geometry();
};

TEST_F(UnfoldTest, DoesNotChangePlacesInThePart) {
  EXPECT_EQ(unfold(geometry_, {2, Point(3, 4)}, 2, Point(), 0), Point(3, 4));
}

// Faces 0 to 3 of the hexahedron form a ring without rotation; each is 480 units wide.
TEST_F(UnfoldTest, UnfoldsNeighboursIntoThePlane) {
  EXPECT_EQ(unfold(geometry_, {1, Point(-200 * kUnit, 7)}, 0, Point(200 * kUnit, 0), 1), Point(280 * kUnit, 7));
  EXPECT_EQ(unfold(geometry_, {3, Point(200 * kUnit, 7)}, 0, Point(-200 * kUnit, 0), 1), Point(-280 * kUnit, 7));
}

TEST_F(UnfoldTest, ChoosesTheNearestPosition) {
  // Face 2 is beyond face 1 and beyond face 3.
  EXPECT_EQ(unfold(geometry_, {2, Point(-200 * kUnit, 0)}, 0, Point(100 * kUnit, 0), 2), Point(760 * kUnit, 0));
  EXPECT_EQ(unfold(geometry_, {2, Point(200 * kUnit, 0)}, 0, Point(-100 * kUnit, 0), 2), Point(-760 * kUnit, 0));
}

TEST_F(UnfoldTest, CrossesAtMostMaxWarps) {
  EXPECT_EQ(unfold(geometry_, {1, Point()}, 0, Point(), 0), std::nullopt);
  EXPECT_EQ(unfold(geometry_, {2, Point()}, 0, Point(), 1), std::nullopt);
}

// Unfolding back gives the original position, for every pair of neighbours.
TEST_F(UnfoldTest, UnfoldingBackIsTheInverse) {
  for (const auto& part : geometry_.parts) {
    for (const Warp& warp : part->warps) {
      const Point here = warp.from.a + Point(5 * kUnit, 3 * kUnit);
      const auto there = unfold(geometry_, {part->id, here}, warp.target, warp.onto.a, 1);
      ASSERT_TRUE(there.has_value());
      EXPECT_EQ(unfold(geometry_, {warp.target, *there}, part->id, here, 1), here);
    }
  }
}

}  // namespace
}  // namespace platon::unfold_test
