#include "shared/physics/step/step_state.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/shared/physics/step/step_parts.h"

namespace platon::step_state_test {
namespace {

struct Recorder : StepObserver {
  void leg(std::uint32_t, std::span<const InstanceView> instances) override {
    homes.push_back(instances.front().position);
  }
  std::vector<Point> homes;
};

class StepStateTest : public StepParts {
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

TEST_F(StepStateTest, MovesAllInstancesEachInItsFrame) {
  buildTwo();
  step().moveTo({107, 3});
  EXPECT_EQ(step().position(), Point(107, 3));
  EXPECT_EQ(instances_.all()[1].position, Point(-3, 507));
  EXPECT_EQ(state_.position, Point(107, 3));
}

TEST_F(StepStateTest, CountsAndReportsMoves) {
  build({});
  Recorder recorder;
  start(&recorder);
  step().moveTo({5, 0});
  step().moveTo({5, 0});
  step().moveTo({5, 6});
  EXPECT_EQ(step().moves, 2);
  EXPECT_EQ(recorder.homes, (std::vector<Point>{{0, 0}, {5, 0}, {5, 6}}));
}

TEST_F(StepStateTest, EveryInstanceMustBeInRange) {
  buildTwo();
  step().setDisplacement(precise(Point(kVelocityLimit - 1, 0)));
  EXPECT_TRUE(step().allInRange({kCoordinateLimit - 600, 0}));
  EXPECT_FALSE(step().allInRange({kCoordinateLimit - 300, 0})) << "the other one is 400 farther along";
  EXPECT_FALSE(step().allInRange({kCoordinateLimit, 0}));
}

TEST_F(StepStateTest, RotatesAllShapes) {
  buildTwo();
  step().rotateShapes(1234);
  EXPECT_EQ(state_.angle, Angle(1234));
  EXPECT_EQ(instances_.all()[1].angle, Angle(9000 + 1234));
}

// Two strips in one line: the frame of the second one begins 2000 subunits farther right.
TEST_F(StepStateTest, RehomeConvertsThePlaceIntoTheNewFrame) {
  buildStrips({950, 7});
  const PrecisePoint beside{5, -6};
  step().place = precise(Point(950, 7)) + beside;
  step().rehome();
  EXPECT_EQ(state_.part, 1u) << "the centre is not beyond the edge";
  step().moveTo({1010, 7});
  step().place = precise(Point(1010, 7)) + beside;
  step().rehome();
  EXPECT_EQ(state_.part, 2u);
  EXPECT_EQ(step().position(), Point(-990, 7));
  EXPECT_EQ(step().place, precise(Point(-990, 7)) + beside);
  step().rehome();
  EXPECT_EQ(state_.crossings, 1u);
}

TEST_F(StepStateTest, RehomeCorrectsTheInstanceThatHasDrifted) {
  buildStrips({950, 7});
  ASSERT_EQ(instances_.all().size(), 2u);
  instances_.all()[1].anchor.x += 1;
  step().moveTo({1010, 7});
  ASSERT_EQ(instances_.all()[1].position, Point(-989, 7));
  step().place = precise(step().position());
  step().rehome();
  EXPECT_EQ(state_.part, 2u);
  EXPECT_EQ(step().position(), Point(-990, 7));
}

// The frame of the second part is turned by 90°.
TEST_F(StepStateTest, RehomeTurnsTheIdealPathWithTheFrame) {
  world_ = World();
  MapPart left(world_, 1);
  left.warp({1000, -5000}, {1000, 5000}, 2, {5000, -1000}, {-5000, -1000});
  left.initialize();
  MapPart up(world_, 2);
  up.warp({-5000, -1000}, {5000, -1000}, 1, {1000, 5000}, {1000, -5000});
  up.initialize();
  Entity entity(world_, square(100));
  left.insert(entity, {950, 7}, Angle());
  start();
  step().moveTo({1010, 7});
  step().place = precise(step().position());
  step().tick = {5, 1};
  step().remaining = {3, -1};
  step().passing = LegPlan{{2, 0}};
  step().contact.emplace();
  step().rehome();
  EXPECT_EQ(step().position(), Point(-7, -990));
  EXPECT_EQ(state_.heading, Angle(9000));
  EXPECT_EQ(step().tick, (PrecisePoint{-1, 5}));
  EXPECT_EQ(step().remaining, (PrecisePoint{1, 3}));
  EXPECT_EQ(step().passing->displacement, (PrecisePoint{0, 2}));
  EXPECT_FALSE(step().contact) << "its placement has another index";
}

TEST_F(StepStateTest, DropsTheInstancesThatAreOutOfReach) {
  buildStrips({950, 7});
  ASSERT_EQ(instances_.all().size(), 2u);
  step().moveTo({893, 7});
  step().dropUnreached();
  EXPECT_EQ(instances_.all().size(), 2u);
  step().moveTo({800, 7});
  step().dropUnreached();
  EXPECT_EQ(instances_.all().size(), 1u);
}

}  // namespace
}  // namespace platon::step_state_test
