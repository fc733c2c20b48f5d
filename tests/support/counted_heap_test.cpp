#include "tests/support/counted_heap.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace platon::counted_heap_test {
namespace {

TEST(CountedHeapTest, CountsAllocations) {
  const std::size_t before = allocations();
  const auto one = std::make_unique<int>(1);
  const std::vector<int> two(100);
  EXPECT_EQ(allocations() - before, 2u);
}

TEST(CountedHeapTest, CountsBytesInUse) {
  const std::size_t before = allocatedBytes();
  {
    const std::vector<char> kept(1 << 20);
    EXPECT_NEAR(static_cast<double>(allocatedBytes() - before), 1 << 20, 8192);
  }
  EXPECT_EQ(allocatedBytes(), before);
}

}  // namespace
}  // namespace platon::counted_heap_test
