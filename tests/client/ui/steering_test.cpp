#include "client/ui/steering.h"

#include <numbers>

#include <gtest/gtest.h>

namespace platon::steering_test {
namespace {

constexpr double kQuarter = std::numbers::pi / 2;

template <class... Key>
HeldKeys holding(Key... keys) {
  HeldKeys held;
  ((held.*keys = true), ...);
  return held;
}

int buttonsOf(Steering& steering, const HeldKeys& keys, double roll, ControlFrame frame) {
  const Input input = steering.input(keys, roll, frame);
  EXPECT_TRUE(input.has(Input::kPresent));
  return input.buttons & ~Input::kPresent;
}

TEST(Steering, ThePlayersFrameIgnoresTheRoll) {
  Steering steering;
  for (const double roll : {0.0, kQuarter, -2.0, 3.1}) {
    EXPECT_EQ(buttonsOf(steering, holding(&HeldKeys::left), roll, ControlFrame::kPlayer), Input::kLeft);
    EXPECT_EQ(buttonsOf(steering, holding(&HeldKeys::right), roll, ControlFrame::kPlayer), Input::kRight);
    EXPECT_EQ(buttonsOf(steering, holding(&HeldKeys::up), roll, ControlFrame::kPlayer), Input::kJump);
    EXPECT_EQ(buttonsOf(steering, holding(&HeldKeys::down), roll, ControlFrame::kPlayer), Input::kDown);
  }
}

// After a quarter turn counter-clockwise, the player's up points left on the screen and its right points up.
TEST(Steering, TheScreensFrameTurnsTheDirections) {
  Steering steering;
  const ControlFrame screen = ControlFrame::kScreen;
  EXPECT_EQ(buttonsOf(steering, {}, kQuarter, screen), 0);
  EXPECT_EQ(buttonsOf(steering, holding(&HeldKeys::left), kQuarter, screen), Input::kJump);
  EXPECT_EQ(buttonsOf(steering, holding(&HeldKeys::up), kQuarter, screen), Input::kRight);
  EXPECT_EQ(buttonsOf(steering, holding(&HeldKeys::right), kQuarter, screen), Input::kDown);
  EXPECT_EQ(buttonsOf(steering, holding(&HeldKeys::down), kQuarter, screen), Input::kLeft);
}

TEST(Steering, UpsideDownLeftIsRight) {
  for (const double roll : {2 * kQuarter, -2 * kQuarter, 2.6}) {
    Steering steering;
    buttonsOf(steering, {}, roll, ControlFrame::kScreen);
    EXPECT_EQ(buttonsOf(steering, holding(&HeldKeys::left), roll, ControlFrame::kScreen), Input::kRight);
  }
}

TEST(Steering, AHeldDirectionKeepsItsMeaning) {
  Steering steering;
  const ControlFrame screen = ControlFrame::kScreen;
  buttonsOf(steering, {}, 0, screen);
  for (const double roll : {0.0, 0.8, kQuarter, 3.0}) {
    EXPECT_EQ(buttonsOf(steering, holding(&HeldKeys::right), roll, screen), Input::kRight);
  }
  buttonsOf(steering, {}, kQuarter, screen);
  EXPECT_EQ(buttonsOf(steering, holding(&HeldKeys::right), kQuarter, screen), Input::kDown);
}

TEST(Steering, JumpAndRestartHaveNoDirection) {
  Steering steering;
  buttonsOf(steering, {}, kQuarter, ControlFrame::kScreen);
  EXPECT_EQ(buttonsOf(steering, holding(&HeldKeys::jump, &HeldKeys::restart), kQuarter, ControlFrame::kScreen),
            Input::kJump | Input::kRestart);
}

}  // namespace
}  // namespace platon::steering_test
