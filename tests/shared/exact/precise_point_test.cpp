#include "platon/exact/precise_point.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/sim/seeded_random.h"

namespace platon::precise_point_test {
namespace {

constexpr std::uint64_t kSeed = 321;
constexpr std::int64_t kOne = PrecisePoint::kOne;

TEST(PrecisePointTest, LatticePointsAreExact) {
  EXPECT_EQ(precise(Point(3, -4)), (PrecisePoint{3 * PrecisePoint::kOne, -4 * PrecisePoint::kOne}));
  for (const Point point : {Point(), Point(1, -1), Point(INT32_MAX, INT32_MIN + 1), Point(kCoordinateLimit - 1, 7)}) {
    EXPECT_EQ(rounded(precise(point)), point);
  }
}

TEST(PrecisePointTest, RoundsHalvesAwayFromZero) {
  EXPECT_EQ(rounded({kOne / 2, -kOne / 2}), Point(1, -1));
  EXPECT_EQ(rounded({kOne / 2 - 1, 1 - kOne / 2}), Point(0, 0));
  EXPECT_EQ(rounded({5 * kOne / 2, -5 * kOne / 2}), Point(3, -3));
}

TEST(PrecisePointTest, AddsAndSubtracts) {
  const PrecisePoint a{5, -70000};
  const PrecisePoint b{-9, 3};
  EXPECT_EQ(a + b, (PrecisePoint{-4, -69997}));
  EXPECT_EQ(a - b, (PrecisePoint{14, -70003}));
  EXPECT_EQ(a + b - b, a);
}

TEST(PrecisePointTest, MidpointsAreExact) {
  EXPECT_EQ(middle({0, 0}, {1, -3}), (PrecisePoint{kOne / 2, -3 * kOne / 2}));
  const Point far(INT32_MAX, -INT32_MAX);
  EXPECT_EQ(middle(far, far), precise(far));
  EXPECT_EQ(middle({7, 8}, {-2, 5}), middle({-2, 5}, {7, 8}));
}

TEST(PrecisePointTest, RotationsRoundOnceTo16Bits) {
  EXPECT_EQ(rotatePrecise({3, -4}, rotationOf(Angle::degrees(90))), precise({4, 3}));
  EXPECT_EQ(rotatePrecise({1, 0}, rotationOf(Angle::degrees(60))), (PrecisePoint{kOne / 2, 58117981})) << "sqrt(3) / 2";
  EXPECT_EQ(rotatePrecise({-1, 0}, rotationOf(Angle::degrees(60))), (PrecisePoint{-kOne / 2, -58117981}));
}

TEST(PrecisePointTest, RotationsAgreeWithRotateUpToRounding) {
  sim::SeededRandom random(kSeed);
  for (int i = 0; i < 20000; ++i) {
    const Point vector = random.vector((2 << (i % 28)) - 1);
    const Rotation rotation = rotationOf(Angle(static_cast<std::int32_t>(random.below(Angle::kTurn))));
    const PrecisePoint error = rotatePrecise(vector, rotation) - precise(rotate(vector, rotation));
    ASSERT_LE(std::abs(error.x), kOne / 2) << "seed " << kSeed << ", round " << i;
    ASSERT_LE(std::abs(error.y), kOne / 2) << "seed " << kSeed << ", round " << i;
  }
}

}  // namespace
}  // namespace platon::precise_point_test
