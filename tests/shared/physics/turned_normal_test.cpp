#include "shared/physics/turned_normal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <utility>

#include "platon/exact/integer.h"
#include "tests/shared/physics/shapes.h"
#include "tests/sim/seeded_random.h"

namespace platon::turned_normal_test {
namespace {

constexpr std::uint64_t kSeed = 12;

TEST(TurnedNormalTest, Uses29BitsAndKeepsTheDirection) {
  sim::SeededRandom random(kSeed);
  for (int i = 0; i < 50000; ++i) {
    const Point normal = random.vector((2 << (i % 27)) - 1);
    if (normal == Point()) continue;
    const auto centidegrees = static_cast<std::int32_t>(random.below(Angle::kTurn));
    const Point turned = turnedNormal(normal, Angle(centidegrees));
    const auto longest = std::max(std::abs(turned.x), std::abs(turned.y));
    ASSERT_LE(longest, 1 << 29) << "seed " << kSeed << ", round " << i;
    ASSERT_GE(longest, 1 << 28) << "seed " << kSeed << ", round " << i;
    const long double expected = std::atan2(static_cast<long double>(normal.y), static_cast<long double>(normal.x)) +
                                 centidegrees * std::numbers::pi_v<long double> / 18000;
    const long double miss =
        std::atan2(static_cast<long double>(turned.y), static_cast<long double>(turned.x)) - expected;
    ASSERT_LT(std::abs(std::sin(miss)), std::ldexp(1.0L, -27)) << "seed " << kSeed << ", round " << i;
    ASSERT_GT(std::cos(miss), 0.0L) << "seed " << kSeed << ", round " << i;
  }
}

TEST(TurnedNormalTest, QuarterTurnsAreExact) {
  for (int quarter = 0; quarter < 4; ++quarter) {
    const Point turned = turnedNormal({3, 1}, Angle::degrees(90 * quarter));
    EXPECT_EQ(cross(turned, rotate(Point(3, 1), Angle::degrees(90 * quarter))), 0);
    EXPECT_GT(dot(turned, rotate(Point(3, 1), Angle::degrees(90 * quarter))), 0);
  }
}

}  // namespace
}  // namespace platon::turned_normal_test
