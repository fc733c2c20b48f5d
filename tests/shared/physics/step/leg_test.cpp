#include "shared/physics/step/leg.h"

#include <gtest/gtest.h>

#include "tests/shared/physics/step/step_parts.h"

namespace platon::leg_test {
namespace {

class LegTest : public StepParts {
 protected:
  Leg prepared(Point displacement, const LegHit* slidesOn = nullptr) {
    Leg leg{precise(displacement)};
    prepareLeg(leg, mover(), precise(mover().position()), slidesOn, refused_);
    return leg;
  }
  // A square of 200 by 200 in the left one of two strips, 50 subunits before the edge.
  void buildStrips(const std::vector<Segment>& second) {
    world_ = twoStrips({}, second);
    Entity entity(world_, square(100));
    MapPart(world_, 1).insert(entity, {850, 0}, Angle());
    start();
  }
};

TEST_F(LegTest, ReachesItsTargetWhereNothingIsInTheWay) {
  build({{{-100, -50}, {100, -50}}});
  const Leg leg = prepared({30, -40});
  EXPECT_EQ(leg.end, Leg::End::kReached);
  EXPECT_FALSE(leg.isStopped());
  EXPECT_EQ(leg.target, Point(30, -40));
}

TEST_F(LegTest, EndsAtTheEarliestEdge) {
  build({{{-100, -90}, {100, -90}}, {{-100, -40}, {100, -40}}});
  const Leg leg = prepared({0, -120});
  EXPECT_EQ(leg.end, Leg::End::kStopped);
  ASSERT_TRUE(leg.isStopped());
  EXPECT_EQ(leg.hit->segment, 1u);
  EXPECT_EQ(leg.hit->hit.time, (Fraction{1, 4}));
}

TEST_F(LegTest, SlidesAlongAnEdgeWithoutMeetingItsSegment) {
  build({{{-100, -10}, {100, -10}}, {{50, -100}, {50, 100}}});
  const Leg into = prepared({0, -1});
  ASSERT_TRUE(into.isStopped());
  const Leg along = prepared({80, 0}, &*into.hit);
  ASSERT_TRUE(along.isStopped());
  EXPECT_EQ(along.hit->segment, 1u);
}

TEST_F(LegTest, IsShortenedToStayWithinTheCoordinates) {
  build({});
  mover().moveTo({kCoordinateLimit - 100, 0});
  mover().start(precise(Point(1024, 0)));
  const Leg leg = prepared({1024, 0});
  EXPECT_EQ(leg.target, Point(kCoordinateLimit - 100 + 64, 0));
  EXPECT_EQ(leg.share, (Fraction{1, 16}));
  EXPECT_EQ(leg.displacement, precise(Point(64, 0)));
}

TEST_F(LegTest, InsertsTheInstanceThatItNeeds) {
  buildStrips({});
  EXPECT_EQ(prepared({40, 0}).end, Leg::End::kReached);
  EXPECT_EQ(instances_.all().size(), 1u) << "it ends 10 subunits before the edge";
  EXPECT_EQ(prepared({60, 0}).end, Leg::End::kReached);
  ASSERT_EQ(instances_.all().size(), 2u);
  EXPECT_EQ(instances_.all()[1].position, Point(-1150, 0));
}

TEST_F(LegTest, EndsAtAWallBehindTheEdge) {
  buildStrips({{{-900, -500}, {-900, 500}}});
  const Leg leg = prepared({300, 0});
  EXPECT_EQ(leg.end, Leg::End::kStopped);
  EXPECT_EQ(leg.hit->placement, 1u);
  EXPECT_EQ(leg.hit->hit.time, (Fraction{150, 300}));
}

// The wall behind the edge protrudes to where the instance would be inserted.
TEST_F(LegTest, EndsWhereItsInstanceCannotBePlaced) {
  buildStrips({{{-1090, -500}, {-1090, 500}}});
  const Leg leg = prepared({300, 0});
  EXPECT_EQ(leg.end, Leg::End::kRefused);
  ASSERT_TRUE(leg.isStopped());
  EXPECT_EQ(leg.hit->placement, 0u);
  EXPECT_EQ(instances_.all().size(), 1u);
}

}  // namespace
}  // namespace platon::leg_test
