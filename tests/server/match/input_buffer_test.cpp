#include "server/match/input_buffer.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace platon::input_buffer_test {
namespace {

Input pressing(int buttons) { return Input{static_cast<std::uint8_t>(buttons | Input::kPresent)}; }

TEST(InputBuffer, ThePlayerIsAbsentUntilItsFirstInput) {
  InputBuffer buffer(10);
  EXPECT_TRUE(buffer.add(12, pressing(1)));
  EXPECT_EQ(buffer.decide(), Input{});
  EXPECT_EQ(buffer.decide(), Input{});
  EXPECT_EQ(buffer.decide(), pressing(1));
  EXPECT_EQ(buffer.next(), 13u);
  EXPECT_EQ(buffer.missed(), 0u);
}

TEST(InputBuffer, HoldsTheLastInputForASecondAndThenReleasesIt) {
  InputBuffer buffer;
  buffer.add(0, pressing(Input::kRight));
  buffer.decide();
  for (std::uint32_t i = 0; i < InputBuffer::kHoldTicks; ++i) EXPECT_EQ(buffer.decide(), pressing(Input::kRight)) << i;
  EXPECT_EQ(buffer.decide(), pressing(0));
  EXPECT_EQ(buffer.missed(), InputBuffer::kHoldTicks + 1u);
}

TEST(InputBuffer, IgnoresInputsForDecidedKnownAndFarTicks) {
  InputBuffer buffer(5);
  EXPECT_FALSE(buffer.add(4, pressing(1)));
  EXPECT_TRUE(buffer.add(5, pressing(1)));
  EXPECT_FALSE(buffer.add(5, pressing(2)));
  EXPECT_TRUE(buffer.add(5 + InputBuffer::kWindow - 1, pressing(3)));
  EXPECT_FALSE(buffer.add(5 + InputBuffer::kWindow, pressing(4)));
  EXPECT_FALSE(buffer.add(UINT32_MAX, pressing(4)));
  EXPECT_EQ(buffer.decide(), pressing(1));
  EXPECT_FALSE(buffer.add(5, pressing(2)));
}

// Its place in the buffer is that of the next tick, which is still free.
TEST(InputBuffer, AnInputBeyondTheWindowIsNotThatOfTheNextTick) {
  InputBuffer buffer(5);
  EXPECT_FALSE(buffer.add(5 + InputBuffer::kWindow, pressing(4)));
  EXPECT_EQ(buffer.decide(), Input{});
}

// Compares the buffer with an unbounded table, on inputs in random order. A tick without input repeats the one before.
TEST(InputBuffer, DecidesEachTickByItsFirstInputInTime) {
  constexpr std::uint64_t seed = 7;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 random(seed);
  InputBuffer buffer;
  std::map<std::uint32_t, Input> table;
  Input last;
  for (std::uint32_t tick = 0; tick < 20000; ++tick) {
    for (int i = 0; i < 2; ++i) {
      const auto target = static_cast<std::uint32_t>(tick + random() % 12);
      const Input input = pressing(static_cast<int>(random() % 32));
      EXPECT_EQ(buffer.add(target, input), table.emplace(target, input).second);
    }
    if (table.contains(tick)) last = table.at(tick);
    ASSERT_EQ(buffer.decide(), last) << "tick " << tick;
  }
}

}  // namespace
}  // namespace platon::input_buffer_test
