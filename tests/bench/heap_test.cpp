#include "tests/bench/heap.h"

#include <gtest/gtest.h>

#include <vector>

namespace platon::bench::heap_test {
namespace {

TEST(Heap, DerivedBytesAreThoseThatACopyDoesNotHave) {
  std::vector<char> live(1 << 20);
  live.resize(1 << 18);  // keeps the memory
  const double derived = derivedBytes(live);
  EXPECT_NEAR(derived, 3.0 * (1 << 18), 8192);
  EXPECT_EQ(live, std::vector<char>(1 << 18));
  EXPECT_EQ(derivedBytes(live), 0);
}

}  // namespace
}  // namespace platon::bench::heap_test
