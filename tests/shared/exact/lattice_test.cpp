#include "shared/exact/lattice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace platon::lattice_test {
namespace {

TEST(LatticeTest, DiscIsComplete) {
  EXPECT_EQ(latticeDiscSize<0>(), 1u);
  EXPECT_EQ(latticeDiscSize<1>(), 5u);
  EXPECT_EQ(latticeDiscSize<6>(), 113u);  // Gauss's circle problem, N(6)
  const auto disc = latticeDisc<6>();
  for (std::int32_t y = -7; y <= 7; ++y) {
    for (std::int32_t x = -7; x <= 7; ++x) {
      EXPECT_EQ(std::count(disc.begin(), disc.end(), Point(x, y)), x * x + y * y <= 36) << x << " " << y;
    }
  }
}

TEST(LatticeTest, DiscIsSortedByDistanceThenRow) {
  const auto disc = latticeDisc<6>();
  EXPECT_EQ(disc.front(), Point());
  EXPECT_TRUE(std::is_sorted(disc.begin(), disc.end(), [](Point a, Point b) {
    const auto key = [](Point p) { return std::array<std::int64_t, 3>{squaredLength(p), p.y, p.x}; };
    return key(a) < key(b);
  }));
}

}  // namespace
}  // namespace platon::lattice_test
