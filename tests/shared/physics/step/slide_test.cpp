#include "shared/physics/step/slide.h"

#include <gtest/gtest.h>

#include "tests/shared/physics/step/step_parts.h"

namespace platon::slide_test {
namespace {

constexpr std::int64_t kOne = PrecisePoint::kOne;

// Above a floor of length 200, on which the square of 20 by 20 stands at (0, 0).
class SlideTest : public StepParts {
 protected:
  SlideTest() { build({{{-100, -10}, {100, -10}}}); }

  Slide slideBy(PrecisePoint displacement) {
    Slide slide{instances_, precise(mover().position())};
    slide.tick = slide.remaining = displacement;
    return slide;
  }
  // The next leg of the path, which the path then has made.
  Leg made(Slide& slide) {
    const LegPlan plan = slide.next();
    Leg leg{plan.displacement};
    prepareLeg(leg, mover(), slide.place, plan.slides ? &*slide.contact : nullptr, refused_);
    const PrecisePoint end = slide.endOf(leg, plan);
    slide.remaining = slide.remainingAfter(leg, plan);
    slide.place = end;
    slide.contact = leg.hit;
    return leg;
  }
};

TEST_F(SlideTest, IsFreeWithoutAContact) {
  const LegPlan plan = slideBy({3 * kOne, 5 * kOne}).next();
  EXPECT_EQ(plan.displacement, (PrecisePoint{3 * kOne, 5 * kOne}));
  EXPECT_FALSE(plan.slides);
}

TEST_F(SlideTest, LeavesAnEdgeThatDoesNotStopIt) {
  Slide slide = slideBy({kOne, -kOne});
  made(slide);
  ASSERT_TRUE(slide.contact);
  slide.remaining = {3 * kOne, kOne / 8};
  EXPECT_FALSE(slide.next().slides);
}

// The path does not depend on the lattice: from 3/8 above the floor, by (40, -2).
TEST_F(SlideTest, StopsExactlyOnTheEdgeAndSlidesAlongIt) {
  Slide slide = slideBy({40 * kOne, -2 * kOne});
  slide.place = {0, 3 * kOne / 8};
  made(slide);
  EXPECT_EQ(slide.place, (PrecisePoint{15 * kOne / 2, 0}));
  EXPECT_EQ(slide.remaining, (PrecisePoint{65 * kOne / 2, -13 * kOne / 8}));
  const LegPlan plan = slide.next();
  EXPECT_TRUE(plan.slides);
  EXPECT_FALSE(plan.cut);
  EXPECT_EQ(plan.displacement, (PrecisePoint{65 * kOne / 2, 0}));
  EXPECT_EQ(plan.share, (Fraction{1, 1}));
}

// The floor ends at x = 100, where the left side of the square is when its centre is at 110.
TEST_F(SlideTest, ASlideEndsWithTheEdge) {
  Slide slide = slideBy({220 * kOne, -kOne});
  made(slide);
  const LegPlan plan = slide.next();
  EXPECT_TRUE(plan.slides);
  EXPECT_TRUE(plan.cut);
  EXPECT_EQ(plan.displacement, (PrecisePoint{110 * kOne, 0}));
  EXPECT_EQ(plan.share, (Fraction{1, 2}));
  const Leg leg{plan.displacement};
  EXPECT_EQ(slide.remainingAfter(leg, plan), (PrecisePoint{110 * kOne, -kOne / 2}));
}

TEST_F(SlideTest, AtTheEndOfTheEdgeItLeadsPastTheCorner) {
  Slide slide = slideBy({0, -kOne});
  made(slide);
  slide.place = {110 * kOne, 0};
  slide.remaining = {5 * kOne, -kOne};
  EXPECT_FALSE(slide.next().slides);
  EXPECT_EQ(slide.next().displacement, slide.remaining);
  slide.remaining = {-5 * kOne, -kOne};
  EXPECT_TRUE(slide.next().slides) << "back along the edge";
}

TEST_F(SlideTest, RestsWhereItWouldSlideByLessThanASubunit) {
  Slide slide = slideBy({kOne - 1, -9 * kOne});
  made(slide);
  const LegPlan plan = slide.next();
  EXPECT_TRUE(plan.slides);
  EXPECT_EQ(plan.displacement, PrecisePoint());
  slide.tick.x = 2 * kOne;
  EXPECT_NE(slide.next().displacement, PrecisePoint()) << "the rest of a longer slide";
}

TEST_F(SlideTest, TheWayPastAnEndComesFirst) {
  Slide slide = slideBy({40 * kOne, -kOne});
  made(slide);
  slide.passing = LegPlan{{kOne, 2 * kOne}};
  EXPECT_EQ(slide.next().displacement, (PrecisePoint{kOne, 2 * kOne}));
}

// On the upper end of a slope: the obstacle of the slope has a level edge that ends at (-90, 0), and the slope follows.
TEST_F(SlideTest, TurnsACornerToTheNextEdgeThatStopsIt) {
  build({{{-100, -10}, {100, -60}}});
  mover().moveTo({-100, 0});
  Slide slide = slideBy({0, -kOne});
  made(slide);
  ASSERT_TRUE(slide.contact);
  ASSERT_EQ(slide.contact->edge.half.normal, Point(0, 20));
  const PrecisePoint corner{-90 * kOne, 0};
  const auto normalAfter = [&](PrecisePoint remaining) {
    LegHit hit = *slide.contact;
    slide.remaining = remaining;
    slide.turnCorner(hit, corner);
    return hit.edge.half.normal;
  };
  EXPECT_EQ(normalAfter({kOne, -2 * kOne}), Point(50, 200)) << "into the slope";
  EXPECT_EQ(normalAfter({5 * kOne, -kOne}), Point(0, 20)) << "past the corner";
  EXPECT_EQ(normalAfter({-kOne, -2 * kOne}), Point(0, 20)) << "back along the level edge";
}

TEST_F(SlideTest, ABodyIsCaughtBetweenEdgesThatLeadIntoEachOther) {
  build({{{-100, -10}, {100, -10}}, {{10, -5}, {10, 100}}});
  Slide slide = slideBy({9 * kOne, -7 * kOne});
  made(slide);
  ASSERT_TRUE(slide.contact);
  const LegPlan plan = slide.next();
  Leg leg{plan.displacement};
  prepareLeg(leg, mover(), slide.place, &*slide.contact, refused_);
  ASSERT_TRUE(leg.isStopped());
  EXPECT_FALSE(slide.isOnContact(*leg.hit));
  EXPECT_TRUE(slide.isOnContact(*slide.contact));
  EXPECT_TRUE(slide.isCaughtAt(*leg.hit));
  slide.remaining = {9 * kOne, 7 * kOne};
  EXPECT_FALSE(slide.isCaughtAt(*leg.hit)) << "the wall leads up, away from the floor";
}

TEST_F(SlideTest, TurnsWithTheFrame) {
  Slide slide = slideBy({5 * kOne, -kOne});
  made(slide);
  slide.passing = LegPlan{{kOne, 0}};
  const PrecisePoint remaining = slide.remaining;
  slide.rotateFrame(Angle(9000));
  EXPECT_EQ(slide.tick, (PrecisePoint{kOne, 5 * kOne}));
  EXPECT_EQ(slide.remaining, (PrecisePoint{-remaining.y, remaining.x}));
  EXPECT_EQ(slide.passing->displacement, (PrecisePoint{0, kOne}));
  EXPECT_FALSE(slide.contact);
}

}  // namespace
}  // namespace platon::slide_test
