#include "shared/physics/step/hit_frame.h"

#include <gtest/gtest.h>

#include "tests/shared/physics/step/step_parts.h"

namespace platon::hit_frame_test {
namespace {

// The second part is rotated by 90° against the home part, and has a floor.
class HitFrameTest : public StepParts {
 protected:
  HitFrameTest() {
    addPart(world_, 0, {});
    addPart(world_, 1, {{{-100, 480}, {100, 480}}});
    Entity entity(world_, square(10));
    MapPart(world_, 0).insert(entity, {0, 0}, Angle());
    MapPart(world_, 1).insert(entity, {0, 500}, Angle(9000));
    start();
  }
};

TEST_F(HitFrameTest, LeadsFromThePartOfTheHitToTheHomePart) {
  const auto hit = collider_.first(instances_, {0, 0}, {-30, 0});  // downwards in the second part
  ASSERT_TRUE(hit);
  ASSERT_EQ(hit->placement, 1u);
  EXPECT_EQ(placementOf(instances_, *hit).position, Point(0, 500));
  EXPECT_EQ(segmentOf(instances_, *hit), (Segment{{-100, 480}, {100, 480}}));
  const Point up = normalOf(instances_, *hit);
  EXPECT_TRUE(up.x == 0 && up.y > 0);
  const Point right = homeNormalOf(instances_, *hit);
  EXPECT_TRUE(right.x > 0 && right.y == 0);
  const PrecisePoint displacement{7, 3};
  EXPECT_EQ(fromHome(instances_, *hit, displacement), (PrecisePoint{-3, 7}));
  EXPECT_EQ(toHome(instances_, *hit, fromHome(instances_, *hit, displacement)), displacement);
}

TEST_F(HitFrameTest, InsideOfASegmentTheNormalLeadsToItsLeft) {
  LegHit hit{1, 0, {}};
  hit.hit.side = Hit::Side::kInside;
  EXPECT_EQ(normalOf(instances_, hit), Point(0, 200));
  EXPECT_TRUE(homeNormalOf(instances_, hit).x > 0 && homeNormalOf(instances_, hit).y == 0);
}

TEST_F(HitFrameTest, AHitOfTheHomeInstanceIsInItsFrame) {
  const LegHit hit{};
  const PrecisePoint displacement{7, 3};
  EXPECT_EQ(fromHome(instances_, hit, displacement), displacement);
  EXPECT_EQ(toHome(instances_, hit, displacement), displacement);
}

}  // namespace
}  // namespace platon::hit_frame_test
