// Legs of the ideal path, free and along edges.
#include <gtest/gtest.h>

#include "shared/physics/step/stages.h"
#include "tests/shared/physics/step/step_parts.h"

namespace platon::leg_test {
namespace {

constexpr std::int64_t kOne = PrecisePoint::kOne;

// Of a square of 200 by 200 that is 50 subunits before the edge between two strips.
constexpr Point kBeforeTheEdge{850, 0};

class LegTest : public StepParts {
 protected:
  Leg found(Point displacement) {
    step().place = precise(step().position());
    return findLeg(step(), {precise(displacement)});
  }
};

TEST_F(LegTest, ReachesItsTargetWhereNothingIsInTheWay) {
  build({{{-100, -50}, {100, -50}}});
  const Leg leg = found({30, -40});
  EXPECT_EQ(leg.end, Leg::End::kReached);
  EXPECT_FALSE(leg.isStopped());
  EXPECT_EQ(leg.target, Point(30, -40));
}

TEST_F(LegTest, EndsAtTheEarliestEdge) {
  build({{{-100, -90}, {100, -90}}, {{-100, -40}, {100, -40}}});
  const Leg leg = found({0, -120});
  EXPECT_EQ(leg.end, Leg::End::kStopped);
  ASSERT_TRUE(leg.isStopped());
  EXPECT_EQ(leg.hit->segment, 1u);
  EXPECT_EQ(leg.hit->hit.time, (Fraction{1, 4}));
}

TEST_F(LegTest, SlidesAlongAnEdgeWithoutMeetingItsSegment) {
  build({{{-100, -10}, {100, -10}}, {{50, -100}, {50, 100}}});
  const Leg into = found({0, -1});
  ASSERT_TRUE(into.isStopped());
  step().contact = into.hit;
  const Leg along = findLeg(step(), {precise(Point(80, 0)), {1, 1}, true});
  ASSERT_TRUE(along.isStopped());
  EXPECT_EQ(along.hit->segment, 1u);
}

TEST_F(LegTest, IsShortenedToStayWithinTheCoordinates) {
  build({});
  step().moveTo({kCoordinateLimit - 100, 0});
  step().setDisplacement(precise(Point(1024, 0)));
  const Leg leg = found({1024, 0});
  EXPECT_EQ(leg.target, Point(kCoordinateLimit - 100 + 64, 0));
  EXPECT_EQ(leg.share, (Fraction{1, 16}));
  EXPECT_EQ(leg.displacement, precise(Point(64, 0)));
}

TEST_F(LegTest, InsertsTheInstanceThatItNeeds) {
  buildStrips(kBeforeTheEdge);
  EXPECT_EQ(found({40, 0}).end, Leg::End::kReached);
  EXPECT_EQ(instances_.all().size(), 1u) << "it ends 10 subunits before the edge";
  EXPECT_EQ(found({60, 0}).end, Leg::End::kReached);
  ASSERT_EQ(instances_.all().size(), 2u);
  EXPECT_EQ(instances_.all()[1].position, Point(-1150, 0));
}

TEST_F(LegTest, EndsAtAWallBehindTheEdge) {
  buildStrips(kBeforeTheEdge, {{{-900, -500}, {-900, 500}}});
  const Leg leg = found({300, 0});
  EXPECT_EQ(leg.end, Leg::End::kStopped);
  EXPECT_EQ(leg.hit->placement, 1u);
  EXPECT_EQ(leg.hit->hit.time, (Fraction{150, 300}));
}

// The wall behind the edge protrudes to where the instance would be inserted.
TEST_F(LegTest, EndsWhereItsInstanceCannotBePlaced) {
  buildStrips(kBeforeTheEdge, {{{-1090, -500}, {-1090, 500}}});
  const Leg leg = found({300, 0});
  EXPECT_EQ(leg.end, Leg::End::kRefused);
  ASSERT_TRUE(leg.isStopped());
  EXPECT_EQ(leg.hit->placement, 0u);
  EXPECT_EQ(instances_.all().size(), 1u);
}

// Above a floor of length 200, on which the square of 20 by 20 stands at (0, 0).
class SlideTest : public StepParts {
 protected:
  SlideTest() { build({{{-100, -10}, {100, -10}}}); }

  void slideBy(PrecisePoint displacement) {
    step().place = precise(step().position());
    step().setDisplacement(displacement);
  }
  // The next leg of the path, which the path then has made.
  Leg made() {
    Leg leg = findLeg(step(), planLeg(step()));
    const PrecisePoint end = placeAfter(step(), leg);
    step().remaining = remainingAfter(step(), leg);
    step().place = end;
    step().contact = leg.hit;
    return leg;
  }
};

TEST_F(SlideTest, IsFreeWithoutAContact) {
  slideBy({3 * kOne, 5 * kOne});
  const LegPlan plan = planLeg(step());
  EXPECT_EQ(plan.displacement, (PrecisePoint{3 * kOne, 5 * kOne}));
  EXPECT_FALSE(plan.slides);
}

TEST_F(SlideTest, LeavesAnEdgeThatDoesNotStopIt) {
  slideBy({kOne, -kOne});
  made();
  ASSERT_TRUE(step().contact);
  step().remaining = {3 * kOne, kOne / 8};
  EXPECT_FALSE(planLeg(step()).slides);
}

// The path does not depend on the lattice: from 3/8 above the floor, by (40, -2).
TEST_F(SlideTest, StopsExactlyOnTheEdgeAndSlidesAlongIt) {
  slideBy({40 * kOne, -2 * kOne});
  step().place = {0, 3 * kOne / 8};
  made();
  EXPECT_EQ(step().place, (PrecisePoint{15 * kOne / 2, 0}));
  EXPECT_EQ(step().remaining, (PrecisePoint{65 * kOne / 2, -13 * kOne / 8}));
  const LegPlan plan = planLeg(step());
  EXPECT_TRUE(plan.slides);
  EXPECT_FALSE(plan.cut);
  EXPECT_EQ(plan.displacement, (PrecisePoint{65 * kOne / 2, 0}));
  EXPECT_EQ(plan.share, (Fraction{1, 1}));
}

// The floor ends at x = 100, where the left side of the square is when its centre is at 110.
TEST_F(SlideTest, ASlideEndsWithTheEdge) {
  slideBy({220 * kOne, -kOne});
  made();
  const LegPlan plan = planLeg(step());
  EXPECT_TRUE(plan.slides);
  EXPECT_TRUE(plan.cut);
  EXPECT_EQ(plan.displacement, (PrecisePoint{110 * kOne, 0}));
  EXPECT_EQ(plan.share, (Fraction{1, 2}));
  EXPECT_EQ(remainingAfter(step(), Leg{plan}), (PrecisePoint{110 * kOne, -kOne / 2}));
}

TEST_F(SlideTest, AtTheEndOfTheEdgeItLeadsPastTheCorner) {
  slideBy({0, -kOne});
  made();
  step().place = {110 * kOne, 0};
  step().remaining = {5 * kOne, -kOne};
  EXPECT_FALSE(planLeg(step()).slides);
  EXPECT_EQ(planLeg(step()).displacement, step().remaining);
  step().remaining = {-5 * kOne, -kOne};
  EXPECT_TRUE(planLeg(step()).slides) << "back along the edge";
}

TEST_F(SlideTest, RestsWhereItWouldSlideByLessThanASubunit) {
  slideBy({kOne - 1, -9 * kOne});
  made();
  const LegPlan plan = planLeg(step());
  EXPECT_TRUE(plan.slides);
  EXPECT_EQ(plan.displacement, PrecisePoint());
  step().tick.x = 2 * kOne;
  EXPECT_NE(planLeg(step()).displacement, PrecisePoint()) << "the rest of a longer slide";
}

TEST_F(SlideTest, TheWayPastAnEndComesFirst) {
  slideBy({40 * kOne, -kOne});
  made();
  step().passing = LegPlan{{kOne, 2 * kOne}};
  EXPECT_EQ(planLeg(step()).displacement, (PrecisePoint{kOne, 2 * kOne}));
}

// On the upper end of a slope: the obstacle of the slope has a level edge that ends at (-90, 0), and the slope follows.
TEST_F(SlideTest, TurnsACornerToTheNextEdgeThatStopsIt) {
  build({{{-100, -10}, {100, -60}}});
  step().moveTo({-100, 0});
  slideBy({0, -kOne});
  made();
  ASSERT_TRUE(step().contact);
  ASSERT_EQ(step().contact->edge.half.normal, Point(0, 20));
  const PrecisePoint corner{-90 * kOne, 0};
  const auto normalAfter = [&](PrecisePoint remaining) {
    LegHit hit = *step().contact;
    step().remaining = remaining;
    turnCorner(step(), hit, corner);
    return hit.edge.half.normal;
  };
  EXPECT_EQ(normalAfter({kOne, -2 * kOne}), Point(50, 200)) << "into the slope";
  EXPECT_EQ(normalAfter({5 * kOne, -kOne}), Point(0, 20)) << "past the corner";
  EXPECT_EQ(normalAfter({-kOne, -2 * kOne}), Point(0, 20)) << "back along the level edge";
}

TEST_F(SlideTest, ABodyIsCaughtBetweenEdgesThatLeadIntoEachOther) {
  build({{{-100, -10}, {100, -10}}, {{10, -5}, {10, 100}}});
  slideBy({9 * kOne, -7 * kOne});
  made();
  ASSERT_TRUE(step().contact);
  const LegPlan plan = planLeg(step());
  const Leg leg = findLeg(step(), plan);
  ASSERT_TRUE(leg.isStopped());
  EXPECT_FALSE(isOnContact(step(), *leg.hit));
  EXPECT_TRUE(isOnContact(step(), *step().contact));
  EXPECT_TRUE(isCaughtAt(step(), *leg.hit));
  step().remaining = {9 * kOne, 7 * kOne};
  EXPECT_FALSE(isCaughtAt(step(), *leg.hit)) << "the wall leads up, away from the floor";
}

}  // namespace
}  // namespace platon::leg_test
