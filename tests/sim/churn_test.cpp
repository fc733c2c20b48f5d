#include "tests/sim/churn.h"

#include <gtest/gtest.h>

namespace platon::sim::churn_test {
namespace {

TEST(ChurnTest, TheSameSeedGivesTheSameInputs) {
  Churn one(7, 3);
  Churn two(7, 3);
  Churn other(8, 3);
  int different = 0;
  for (int tick = 0; tick < 1000; ++tick) {
    const auto inputs = one.next();
    ASSERT_EQ(inputs, two.next());
    different += inputs != other.next();
  }
  EXPECT_GT(different, 500);
}

TEST(ChurnTest, GivesEveryButtonAndPlayersWhoLeaveAndJoin) {
  constexpr std::uint32_t kSlots = 4;
  Churn churn(1, kSlots);
  int buttons = 0;
  int joins = 0;
  int leaves = 0;
  std::vector<Input> last = churn.next();
  for (const Input input : last) EXPECT_TRUE(input.has(Input::kPresent)) << "all players are present at first";
  for (int tick = 0; tick < 10000; ++tick) {
    const auto& inputs = churn.next();
    ASSERT_EQ(inputs.size(), kSlots);
    for (std::uint32_t slot = 0; slot < kSlots; ++slot) {
      ASSERT_TRUE(isInput(inputs[slot]));
      buttons |= inputs[slot].buttons;
      joins += inputs[slot].has(Input::kPresent) && !last[slot].has(Input::kPresent);
      leaves += !inputs[slot].has(Input::kPresent) && last[slot].has(Input::kPresent);
    }
    last = inputs;
  }
  EXPECT_EQ(buttons, 0xff);
  EXPECT_GT(joins, 10);
  EXPECT_GT(leaves, 10);
}

}  // namespace
}  // namespace platon::sim::churn_test
