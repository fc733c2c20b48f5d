#include "shared/physics/step/mover.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/shared/physics/step/step_parts.h"

namespace platon::mover_test {
namespace {

struct Recorder : StepObserver {
  void leg(std::uint32_t, std::span<const InstanceView> instances) override {
    homes.push_back(instances.front().position);
  }
  std::vector<Point> homes;
};

class MoverTest : public StepParts {
 protected:
  // In two parts, in the second one rotated by 90°.
  void buildTwo() {
    addPart(world_, 0, {});
    addPart(world_, 1, {});
    Entity entity(world_, square(10));
    MapPart(world_, 0).insert(entity, {100, 0}, Angle());
    MapPart(world_, 1).insert(entity, {0, 500}, Angle(9000));
    start();
  }
};

TEST_F(MoverTest, MovesAllInstancesEachInItsFrame) {
  buildTwo();
  mover().moveTo({107, 3});
  EXPECT_EQ(mover().position(), Point(107, 3));
  EXPECT_EQ(instances_.all()[1].position, Point(-3, 507));
  EXPECT_EQ(state_.position, Point(107, 3));
}

TEST_F(MoverTest, CountsAndReportsMoves) {
  build({});
  Recorder recorder;
  start(&recorder);
  mover().moveTo({5, 0});
  mover().moveTo({5, 0});
  mover().moveTo({5, 6});
  EXPECT_EQ(mover().moves(), 2);
  EXPECT_EQ(recorder.homes, (std::vector<Point>{{0, 0}, {5, 0}, {5, 6}}));
}

TEST_F(MoverTest, EveryInstanceMustBeInRange) {
  buildTwo();
  mover().start(precise(Point(kVelocityLimit - 1, 0)));
  EXPECT_TRUE(mover().allInRange({kCoordinateLimit - 600, 0}));
  EXPECT_FALSE(mover().allInRange({kCoordinateLimit - 300, 0})) << "the other one is 400 farther along";
  EXPECT_FALSE(mover().allInRange({kCoordinateLimit, 0}));
}

TEST_F(MoverTest, RotatesAllShapes) {
  buildTwo();
  mover().rotateShapes(1234);
  EXPECT_EQ(state_.angle, Angle(1234));
  EXPECT_EQ(instances_.all()[1].angle, Angle(9000 + 1234));
}

// Two strips in one line: the frame of the second one begins 2000 subunits farther right.
TEST_F(MoverTest, RehomeConvertsThePlaceIntoTheNewFrame) {
  world_ = twoStrips();
  Entity entity(world_, square(100));
  MapPart(world_, 1).insert(entity, {950, 7}, Angle());
  start();
  PrecisePoint place = precise(Point(950, 7)) + PrecisePoint{5, -6};
  EXPECT_FALSE(mover().rehome(place)) << "the centre is not beyond the edge";
  mover().moveTo({1010, 7});
  place = precise(Point(1010, 7)) + PrecisePoint{5, -6};
  EXPECT_EQ(mover().rehome(place), Angle());
  EXPECT_EQ(state_.part, 2u);
  EXPECT_EQ(mover().position(), Point(-990, 7));
  EXPECT_EQ(place, precise(Point(-990, 7)) + (PrecisePoint{5, -6}));
  EXPECT_FALSE(mover().rehome(place));
}

TEST_F(MoverTest, DropsTheInstancesThatAreOutOfReach) {
  world_ = twoStrips();
  Entity entity(world_, square(100));
  MapPart(world_, 1).insert(entity, {950, 7}, Angle());
  start();
  ASSERT_EQ(instances_.all().size(), 2u);
  mover().moveTo({893, 7});
  mover().dropUnreached();
  EXPECT_EQ(instances_.all().size(), 2u);
  mover().moveTo({800, 7});
  mover().dropUnreached();
  EXPECT_EQ(instances_.all().size(), 1u);
}

}  // namespace
}  // namespace platon::mover_test
