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

// y comes from the first number, 6457827717110365317, and x from the second, 3203168211198807973, with every compiler.
TEST(SeededRandomTest, AVectorIsTheSameOnEveryMachine) {
  SeededRandom random(1234567);
  EXPECT_EQ(random.vector(1000), Point(-653, -300));
}

}  // namespace
}  // namespace platon::sim::seeded_random_test
