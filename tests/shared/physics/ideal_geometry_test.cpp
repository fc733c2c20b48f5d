#include "shared/physics/ideal_geometry.h"

#include <gtest/gtest.h>

#include <cmath>

#include "shared/physics/tolerances.h"
#include "tests/shared/physics/shapes.h"
#include "tests/sim/seeded_random.h"

namespace platon::ideal_geometry_test {
namespace {

using HalfPlane = Obstacle::HalfPlane;

constexpr std::uint64_t kSeed = 15;
constexpr std::int64_t kOne = PrecisePoint::kOne;
const Convex kSquare = square(10);
const Segment kFloor{{-100, 0}, {100, 0}};
const HalfPlane kTop{{0, 200}, -2000};  // the square stands on the floor at y = 10

TEST(FractionOfTest, IsExactForShortNumbersAndNeverNegative) {
  EXPECT_EQ(fractionOf(3, 7), (Fraction{3, 7}));
  EXPECT_EQ(fractionOf(0, 7), (Fraction{0, 1}));
  EXPECT_EQ(fractionOf(-3, 7), (Fraction{0, 1}));
}

TEST(FractionOfTest, KeepsSixtyBitsOfLongNumbers) {
  const Fraction third = fractionOf((int128{1} << 100) - 1, (int128{1} << 100) * 3);
  EXPECT_NEAR(static_cast<double>(third.numerator) / static_cast<double>(third.denominator), 1.0 / 3, 1e-15);
  EXPECT_LT(third.denominator, std::int64_t{1} << 62);
}

TEST(ScaledTest, IsRoundedAndExactAtBothEnds) {
  const PrecisePoint vector{1001, -1001};
  EXPECT_EQ(scaled(vector, {0, 1}), PrecisePoint());
  EXPECT_EQ(scaled(vector, {5, 5}), vector);
  EXPECT_EQ(scaled(vector, {1, 2}), (PrecisePoint{501, -501})) << "halves away from zero";
}

TEST(ClipIdealTest, AgreesWithTheSweepOnLatticePaths) {
  sim::SeededRandom random(kSeed);
  int hits = 0;
  for (int round = 0; round < 20000; ++round) {
    const Convex shape = randomConvex(random, 40);
    const Segment segment{random.vector(100), round % 8 == 0 ? random.vector(100) : random.vector(300)};
    const Point from = random.vector(200);
    const Point by = random.vector(300);
    Sweep sweep;
    sweep.start(shape, from, by);
    const auto hit = sweep.against(segment);
    if (hit && hit->side == Hit::Side::kInside) continue;
    const auto entered = clipIdeal(shape, segment, precise(from), precise(by));
    ASSERT_EQ(entered.has_value(), hit.has_value()) << "seed " << kSeed << ", round " << round;
    if (!hit) continue;
    ++hits;
    ASSERT_EQ(entered->time, hit->time) << "seed " << kSeed << ", round " << round;
    ASSERT_EQ(halfPlaneOf(shape, segment, entered->edge).normal, hit->normal)
        << "seed " << kSeed << ", round " << round;
  }
  EXPECT_GT(hits, 2000);
}

// For places on an edge: some near its middle, some at its ends, some in the middle of the obstacle.
TEST(ClipIdealTest, AnObstacleAndItsTouchedEdgeAgreeWithTheShapeAndTheSegment) {
  sim::SeededRandom random(kSeed + 1);
  int atOnce = 0;
  for (int round = 0; round < 20000; ++round) {
    const Convex shape = randomConvex(random, 40);
    const Segment segment{random.vector(60), round % 8 == 0 ? random.vector(60) : random.vector(300)};
    Obstacle obstacle;
    obstacle.build(shape, segment);
    const Obstacle::HalfPlane half = obstacle.halfPlane(random.below(obstacle.halfPlaneCount()));
    const Point noise = random.vector(3 * static_cast<std::int32_t>(Tolerances::kOnEdge));
    PrecisePoint from = putOnto(half, precise(random.vector(100)));
    if (round % 4 == 0) {  // where two edges, or what would continue them, meet
      const Obstacle::HalfPlane other = obstacle.halfPlane(random.below(obstacle.halfPlaneCount()));
      for (int i = 0; i < 100; ++i) from = putOnto(i % 2 == 0 ? other : half, from);
    }
    from = from + PrecisePoint{noise.x, noise.y};
    const PrecisePoint by = precise(random.vector(round % 3 == 0 ? 2 : 300));
    const Box path = Box{rounded(from), rounded(from)}.swept(rounded(by)).grown(2);
    const auto entered = clipIdeal(obstacle, path, from, by);
    ASSERT_EQ(entered, clipIdeal(shape, segment, from, by)) << "seed " << kSeed + 1 << ", round " << round;
    const auto touched = touchedEdge(obstacle, path, from, by);
    if (!touched) continue;
    ++atOnce;
    ASSERT_EQ(entered, (IdealEntry{{0, 1}, *touched})) << "seed " << kSeed + 1 << ", round " << round;
  }
  EXPECT_GT(atOnce, 800);
}

TEST(ClipIdealTest, APlaceOnAnEdgeTouchesIt) {
  const auto from = [](std::int64_t above) { return PrecisePoint{0, 10 * kOne + above}; };
  const PrecisePoint down{0, -5 * kOne};
  for (const std::int64_t above : {-Tolerances::kOnEdge, std::int64_t{0}, Tolerances::kOnEdge}) {
    EXPECT_EQ(clipIdeal(kSquare, kFloor, from(above), down)->time, (Fraction{0, 1})) << above;
    EXPECT_FALSE(clipIdeal(kSquare, kFloor, from(above), {7 * kOne, 0})) << above;
  }
}

TEST(ClipIdealTest, APathThatStartsInsideEntersThroughTheNearestEdgeUnlessItLeavesThroughIt) {
  const PrecisePoint inside{0, 9 * kOne};
  const auto entered = clipIdeal(kSquare, kFloor, inside, {3 * kOne, -kOne});
  ASSERT_TRUE(entered);
  EXPECT_EQ(entered->time, (Fraction{0, 1}));
  EXPECT_EQ(halfPlaneOf(kSquare, kFloor, entered->edge).normal, kTop.normal);
  EXPECT_FALSE(clipIdeal(kSquare, kFloor, inside, {3 * kOne, kOne}));
}

// Both paths lead into the upper right corner of the obstacle.
TEST(ClipIdealTest, AtACornerASideTakesPrecedenceAndThenTheSmallestAngle) {
  const Segment point{{0, 0}, {0, 0}};
  const PrecisePoint steep{-10 * kOne, -20 * kOne};
  const PrecisePoint flat{-20 * kOne, -10 * kOne};
  const auto normal = [](const Segment& segment, PrecisePoint corner, PrecisePoint by) {
    const PrecisePoint from = corner - PrecisePoint{by.x / 2, by.y / 2};
    const auto entered = clipIdeal(kSquare, segment, from, by);
    return entered ? halfPlaneOf(kSquare, segment, entered->edge).normal : Point();
  };
  EXPECT_EQ(normal(kFloor, {110 * kOne, 10 * kOne}, steep).x, 0) << "the side";
  EXPECT_EQ(normal(kFloor, {110 * kOne, 10 * kOne}, flat).x, 0) << "the side";
  EXPECT_EQ(normal(point, {10 * kOne, 10 * kOne}, steep).y, 0) << "the edge on the right";
  EXPECT_EQ(normal(point, {10 * kOne, 10 * kOne}, flat).x, 0) << "the upper edge";
}

// On a level floor, two fine units too low, to a segment that begins there and rises by 1 in 525. The path is on its
// side 1 050 fine units before it is on the edge of its end.
TEST(ClipIdealTest, AtACornerThatIsAlmostStraightASideTakesPrecedenceOverTheEnd) {
  const Convex octagon({{3633, -8768},
                        {8767, -3633},
                        {8768, 3635},
                        {3635, 8769},
                        {-3634, 8768},
                        {-8768, 3634},
                        {-8767, -3633},
                        {-3633, -8768}});
  const Segment rise{{0, 0}, {-15744, 30}};
  const Point corner(3633, 8768);
  for (const std::int64_t above : {-2, -1, 0, 1, 2}) {
    const auto entered =
        clipIdeal(octagon, rise, precise(corner + Point(223, 0)) + PrecisePoint{0, above}, {-718 * kOne, 0});
    ASSERT_TRUE(entered);
    EXPECT_EQ(halfPlaneOf(octagon, rise, entered->edge).normal, Point(30, 15744)) << above;
    const double at =
        718 * static_cast<double>(entered->time.numerator) / static_cast<double>(entered->time.denominator);
    EXPECT_NEAR(at, 223, 2e-5) << above;
  }
}

TEST(ObstacleEdgeTest, EveryEdgeEndsWhereTheNextOneBegins) {
  sim::SeededRandom random(kSeed);
  for (int round = 0; round < 2000; ++round) {
    const Convex shape = randomConvex(random, 1000);
    const Segment segment{random.vector(1000), round % 8 == 0 ? Point(5, 7) : random.vector(5000)};
    HalfPlane half = halfPlaneOf(shape, segment, 0);
    const Point first = half.normal;
    std::size_t edges = 0;
    do {
      const ObstacleEdge edge = edgeOf(shape, segment, half);
      ASSERT_LT(edge.low, edge.high) << "seed " << kSeed << ", round " << round;
      const HalfPlane next = halfPlaneOf(shape, segment, adjacent(shape, segment, half.normal, false));
      ASSERT_GT(cross(half.normal, next.normal), 0);
      ASSERT_EQ(cross(halfPlaneOf(shape, segment, adjacent(shape, segment, next.normal, true)).normal, half.normal), 0);
      // The end of the edge, times the squared length of its normal, is on the next edge.
      const int128 length = squaredLength(half.normal);
      const Point tangent = perpendicular(half.normal);
      const int128 x = int128{tangent.x} * edge.high - int128{half.normal.x} * half.offset;
      const int128 y = int128{tangent.y} * edge.high - int128{half.normal.y} * half.offset;
      ASSERT_TRUE(next.normal.x * x + next.normal.y * y + next.offset * length == 0) << "round " << round;
      half = next;
      ++edges;
    } while (cross(half.normal, first) != 0 || dot(half.normal, first) < 0);
    ASSERT_GE(edges, 3u);
    ASSERT_LE(edges, shape.edges().size() + 2);
  }
}

TEST(SlideRoomTest, IsTheDistanceToTheEndAhead) {
  const ObstacleEdge edge = edgeOf(kSquare, kFloor, kTop);  // from -110 to 110
  const std::int64_t length = kTop.normal.y;
  const SlideRoom right = roomOn(edge, {100 * kOne, 10 * kOne}, {10 * kOne, -9 * kOne});
  EXPECT_TRUE(right.wanted == int128{10 * kOne} * length && right.left == int128{10 * kOne} * length);
  EXPECT_TRUE(right.back && right.isEnough()) << "perpendicular(normal) points to the left";
  const SlideRoom left = roomOn(edge, {100 * kOne, 10 * kOne}, {-211 * kOne, 0});
  EXPECT_TRUE(left.wanted == int128{211 * kOne} * length && left.left == int128{210 * kOne} * length);
  EXPECT_FALSE(left.back || left.isEnough());
}

TEST(SlideOnTest, KeepsTheComponentAlongTheEdge) {
  const ObstacleEdge edge = edgeOf(kSquare, kFloor, kTop);
  const EdgeSlide slide = slideAlong(edge, {0, 10 * kOne}, {7 * kOne + 1, -3 * kOne});
  EXPECT_EQ(slide.displacement, (PrecisePoint{7 * kOne + 1, 0}));
  EXPECT_EQ(slide.share, (Fraction{1, 1}));
  EXPECT_FALSE(slide.cut);
  EXPECT_TRUE(slide.back) << "perpendicular(normal) points to the left";
}

TEST(SlideOnTest, EndsWithTheEdge) {
  const ObstacleEdge edge = edgeOf(kSquare, kFloor, kTop);
  for (const int sign : {1, -1}) {  // the edge goes from -110 to 110
    const EdgeSlide slide = slideAlong(edge, {sign * 100 * kOne, 10 * kOne}, {sign * 40 * kOne, -9 * kOne});
    EXPECT_EQ(slide.displacement, (PrecisePoint{sign * 10 * kOne, 0}));
    EXPECT_EQ(slide.share, (Fraction{1, 4}));
    EXPECT_TRUE(slide.cut);
  }
}

TEST(SlideOnTest, GoesNowhereBeyondTheEnd) {
  const EdgeSlide slide = slideAlong(edgeOf(kSquare, kFloor, kTop), {115 * kOne, 10 * kOne}, {kOne, -kOne});
  EXPECT_TRUE(slide.cut);
  EXPECT_EQ(slide.displacement, PrecisePoint());
  EXPECT_EQ(slide.share, (Fraction{0, 1}));
}

TEST(PutOntoTest, ProjectsOntoTheEdgeAndThenDoesNothing) {
  sim::SeededRandom random(kSeed);
  for (int round = 0; round < 20000; ++round) {
    const Point normal = random.vector(1 << 29);
    if (normal == Point()) continue;
    const HalfPlane half{normal, dot(normal, random.vector(1 << 28))};
    const Point near = random.vector(1 << 28);
    const PrecisePoint point = precise(near) + PrecisePoint{random.vector(1 << 26).x, random.vector(1 << 26).y};
    const PrecisePoint onto = putOnto(half, point);
    const int128 distance = distanceTo(half, onto);
    const int128 rounding = int128{Tolerances::kRounding} * half.oneNorm();
    ASSERT_TRUE(-rounding <= distance && distance <= rounding) << "seed " << kSeed << ", round " << round;
    ASSERT_EQ(putOnto(half, onto), onto) << "seed " << kSeed << ", round " << round;
  }
}

}  // namespace
}  // namespace platon::ideal_geometry_test
