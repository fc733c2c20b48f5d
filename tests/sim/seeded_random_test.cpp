#include "tests/sim/seeded_random.h"

#include <gtest/gtest.h>

namespace platon::sim::seeded_random_test {
namespace {

TEST(SeededRandomTest, IsSplitMix64) {
  SeededRandom random(1234567);
  EXPECT_EQ(random.next(), 6457827717110365317U);
  EXPECT_EQ(random.next(), 3203168211198807973U);
  EXPECT_EQ(random.next(), 9817491932198370423U);
}

TEST(SeededRandomTest, StaysBelowTheBound) {
  SeededRandom random(5);
  int seen[7] = {};
  for (int i = 0; i < 7000; ++i) ++seen[random.below(7)];
  for (const int count : seen) EXPECT_GT(count, 800);
  EXPECT_EQ(random.below(1), 0u);
}

TEST(SeededRandomTest, VectorsFillTheDisc) {
  SeededRandom random(5);
  int quarters[4] = {};
  std::int64_t longest = 0;
  for (int i = 0; i < 4000; ++i) {
    const Point vector = random.vector(1000);
    ASSERT_LE(squaredLength(vector), 1000 * 1000);
    longest = std::max(longest, squaredLength(vector));
    ++quarters[(vector.x > 0) * 2 + (vector.y > 0)];
  }
  for (const int count : quarters) EXPECT_GT(count, 800);
  EXPECT_GT(longest, 990 * 990);
  EXPECT_EQ(random.vector(0), Point());
  constexpr std::int32_t maxLength = (1 << 28) - 1;
  EXPECT_LE(squaredLength(random.vector(maxLength)), std::int64_t{maxLength} * maxLength);
}

// y comes from the first number, 6457827717110365317, and x from the second, 3203168211198807973, with every compiler.
TEST(SeededRandomTest, AVectorIsTheSameOnEveryMachine) {
  SeededRandom random(1234567);
  EXPECT_EQ(random.vector(1000), Point(-653, -300));
}

}  // namespace
}  // namespace platon::sim::seeded_random_test
