#include "shared/physics/step/turn_step.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>

#include "tests/shared/physics/step/step_parts.h"

namespace platon::turn_step_test {
namespace {

class TurnStepTest : public StepParts {
 protected:
  // Returns the segment that stopped the rotation.
  std::optional<SegmentRef> turn(std::int32_t centidegrees) {
    const std::size_t events = events_.size();
    TurnStep(mover(), contacts_).turn(centidegrees);
    for (const StepEvents::Event& event : events_.since(events)) {
      if (event.kind == StepEvents::Kind::kTouch) return event.contact.segment;
    }
    return std::nullopt;
  }
  void place(const Convex& shape, std::uint32_t part, Point at) {
    Entity entity(world_, shape);
    MapPart(world_, part).insert(entity, at, Angle());
    start();
  }
};

TEST_F(TurnStepTest, TurnsByTheWholeAngleWhereNothingBlocks) {
  build({{{-100, -50}, {100, -50}}});
  EXPECT_FALSE(turn(12345));
  EXPECT_EQ(state_.angle, Angle(12345));
  EXPECT_FALSE(turn(-345));
  EXPECT_EQ(state_.angle, Angle(12000));
}

// The corner of the square, 1414 from its centre, meets the floor 1200 below it at 45° - acos(1200 / 1414) = 13.05°.
TEST_F(TurnStepTest, StopsAtTheLastFreeAngleAndSaysSo) {
  addPart(world_, 0, {{{-9000, -1200}, {9000, -1200}}});
  place(square(1000), 0, {0, 0});
  ASSERT_TRUE(turn(4500));
  EXPECT_NEAR(state_.angle.centidegrees(), 1305, 5);
  const Angle last = state_.angle;
  EXPECT_TRUE(turn(1)) << "not a centidegree more";
  EXPECT_EQ(state_.angle, last);
  EXPECT_FALSE(turn(-100));
}

TEST_F(TurnStepTest, InsertsTheInstancesThatTheShapeReaches) {
  world_ = twoStrips();
  place(square(100), 1, {880, 0});
  ASSERT_EQ(instances_.all().size(), 1u);
  EXPECT_FALSE(turn(4500));
  EXPECT_EQ(instances_.all().size(), 2u) << "a corner is over the edge";
}

TEST_F(TurnStepTest, ASegmentBehindAnEdgeBlocks) {
  world_ = twoStrips({}, {{{-985, -500}, {-985, 500}}});
  place(square(100), 1, {880, 0});
  const auto blocker = turn(4500);
  ASSERT_TRUE(blocker);
  EXPECT_EQ(blocker->part, 2u);
  EXPECT_LT(state_.angle.centidegrees(), 4500);
}

}  // namespace
}  // namespace platon::turn_step_test
