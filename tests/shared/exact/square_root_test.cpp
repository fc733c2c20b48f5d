#include "shared/exact/square_root.h"

#include <gtest/gtest.h>

#include "tests/sim/seeded_random.h"

namespace platon::square_root_test {
namespace {

constexpr std::uint64_t kSeed = 99;

TEST(SquareRootTest, RoundsDownForAllSmallValues) {
  std::int64_t root = 0;
  for (std::int64_t value = 0; value < 5000; ++value) {
    if ((root + 1) * (root + 1) <= value) ++root;
    EXPECT_EQ(static_cast<std::int64_t>(squareRootFloor(value)), root) << value;
  }
}

TEST(SquareRootTest, ChangesExactlyAtSquares) {
  sim::SeededRandom random(kSeed);
  for (int i = 0; i < 5000; ++i) {
    const int128 root = 1 + static_cast<std::int64_t>(random.next() >> (3 + i % 61));
    ASSERT_TRUE(squareRootFloor(root * root) == root) << "seed " << kSeed << ", round " << i;
    ASSERT_TRUE(squareRootFloor(root * root - 1) == root - 1) << "seed " << kSeed << ", round " << i;
    ASSERT_TRUE(squareRootFloor(root * root + 2 * root) == root) << "seed " << kSeed << ", round " << i;
  }
}

TEST(SquareRootTest, IsExactForTheLargestValues) {
  const int128 largest = (int128{1} << 124) - 1;
  EXPECT_TRUE(squareRootFloor(largest) == (int128{1} << 62) - 1);
  EXPECT_EQ(squareRootFloor((std::int64_t{1} << 62) - 1), (std::int64_t{1} << 31) - 1);
}

}  // namespace
}  // namespace platon::square_root_test
