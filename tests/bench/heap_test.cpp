#include "tests/bench/heap.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace platon::bench {
namespace {

TEST(Heap, CountsAllocations) {
  const std::size_t before = allocations();
  const auto one = std::make_unique<int>(1);
  const std::vector<int> two(100);
  EXPECT_EQ(allocations() - before, 2u);
}

TEST(Heap, CountsBytesInUse) {
  const std::size_t before = allocatedBytes();
  {
    const std::vector<char> kept(1 << 20);
    EXPECT_NEAR(static_cast<double>(allocatedBytes() - before), 1 << 20, 8192);
  }
  EXPECT_EQ(allocatedBytes(), before);
}

TEST(Heap, DerivedBytesAreThoseThatACopyDoesNotHave) {
  std::vector<char> live(1 << 20);
  live.resize(1 << 18);  // keeps the memory
  const double derived = derivedBytes(live);
  EXPECT_NEAR(derived, 3.0 * (1 << 18), 8192);
  EXPECT_EQ(live, std::vector<char>(1 << 18));
  EXPECT_EQ(derivedBytes(live), 0);
}

}  // namespace
}  // namespace platon::bench
