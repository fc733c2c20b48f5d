#include "tests/sim/button_presses.h"

#include <gtest/gtest.h>

namespace platon::sim::button_presses_test {
namespace {

TEST(ButtonPressesTest, TheSameSeedAndSlotGiveTheSameInputs) {
  ButtonPresses one(7, 3);
  ButtonPresses two(7, 3);
  ButtonPresses other(7, 4);
  int different = 0;
  for (int tick = 0; tick < 1000; ++tick) {
    const Input input = one.next();
    ASSERT_EQ(input, two.next());
    different += !(input == other.next());
  }
  EXPECT_GT(different, 300);
}

TEST(ButtonPressesTest, PressesLeftRightAndJumpAtThePaceOfAPerson) {
  ButtonPresses presses(1, 0);
  int left = 0;
  int right = 0;
  int jump = 0;
  int changes = 0;
  Input last;
  for (int tick = 0; tick < 6000; ++tick) {
    const Input input = presses.next();
    ASSERT_TRUE(input.has(Input::kPresent));
    ASSERT_EQ(input.buttons & ~(Input::kLeft | Input::kRight | Input::kJump | Input::kPresent), 0);
    ASSERT_FALSE(input.has(Input::kLeft) && input.has(Input::kRight));
    left += input.has(Input::kLeft);
    right += input.has(Input::kRight);
    jump += input.has(Input::kJump);
    changes += !(input == last);
    last = input;
  }
  for (const int count : {left, right, jump}) EXPECT_GT(count, 1000);
  EXPECT_GT(changes, 100);
  EXPECT_LT(changes, 1000) << "at most ten changes per second";
}

}  // namespace
}  // namespace platon::sim::button_presses_test
