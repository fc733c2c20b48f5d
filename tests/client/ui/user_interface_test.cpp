#include "client/ui/user_interface.h"

#include <gtest/gtest.h>

namespace platon {
namespace {

using Kind = KeyEvent::Kind;

constexpr int kFullscreenItem = 6;  // below Resume

void tap(UserInterface& interface, Key key, int times = 1) {
  for (int i = 0; i < times; ++i) {
    interface.handle({key, Kind::kPress});
    interface.handle({key, Kind::kRelease});
  }
}

TEST(UserInterface, ResumeBySpaceDoesNotMakeTheBallJump) {
  for (const Key key : {Key::kSpace, Key::kPadA}) {
    UserInterface interface { Settings() };
    tap(interface, Key::kEscape);
    ASSERT_TRUE(interface.menu().open());
    interface.handle({key, Kind::kPress});
    ASSERT_FALSE(interface.menu().open());
    for (int tick = 0; tick < 10; ++tick) EXPECT_FALSE(interface.takeHeld().jump);
    interface.handle({key, Kind::kRelease});
    EXPECT_FALSE(interface.takeHeld().jump);
    tap(interface, key);
    EXPECT_TRUE(interface.takeHeld().jump) << "the next press jumps again";
  }
}

TEST(UserInterface, AKeyTapShorterThanAFrameIsNotLost) {
  UserInterface interface { Settings() };
  tap(interface, Key::kSpace);
  EXPECT_TRUE(interface.takeHeld().jump);
  EXPECT_FALSE(interface.takeHeld().jump);
}

TEST(UserInterface, NoControlIsHeldWhileTheMenuIsOpen) {
  UserInterface interface { Settings() };
  interface.handle({Key::kArrowRight, Kind::kPress});
  EXPECT_TRUE(interface.takeHeld().right);
  tap(interface, Key::kEscape);
  EXPECT_EQ(interface.takeHeld(), HeldKeys());
  tap(interface, Key::kEscape);
  EXPECT_TRUE(interface.takeHeld().right) << "the key is still down";
}

TEST(UserInterface, TheRightArrowInTheMenuTurnsFullScreenOn) {
  for (const Key key : {Key::kArrowRight, Key::kArrowLeft, Key::kPadRight, Key::kEnter}) {
    UserInterface interface { Settings() };
    tap(interface, Key::kEscape);
    tap(interface, Key::kArrowDown, kFullscreenItem);
    tap(interface, key);
    EXPECT_TRUE(interface.settings().fullscreen);
  }
}

TEST(UserInterface, FunctionKeysToggle) {
  UserInterface interface { Settings() };
  for (const bool on : {true, false}) {
    tap(interface, Key::kF1);
    EXPECT_EQ(interface.helpShown(), on);
    tap(interface, Key::kF3);
    EXPECT_EQ(interface.settings().netGraph, on);
    tap(interface, Key::kF11);
    EXPECT_EQ(interface.settings().fullscreen, on);
  }
}

TEST(UserInterface, TheVoteChangesWithEachPressWhileTheMenuIsClosed) {
  UserInterface interface { Settings() };
  EXPECT_FALSE(interface.takeVote());
  tap(interface, Key::kV);
  EXPECT_TRUE(interface.takeVote());
  EXPECT_FALSE(interface.takeVote());
  tap(interface, Key::kV, 2);
  EXPECT_FALSE(interface.takeVote()) << "taken back";
  tap(interface, Key::kEscape);
  tap(interface, Key::kV);
  EXPECT_FALSE(interface.takeVote());
}

TEST(UserInterface, LastMenuItemLeaves) {
  UserInterface interface { Settings() };
  tap(interface, Key::kEscape);
  tap(interface, Key::kArrowUp);
  EXPECT_FALSE(interface.menu().leaving());
  tap(interface, Key::kEnter);
  EXPECT_TRUE(interface.menu().leaving());
}

TEST(UserInterface, StartsWithTheGivenSettings) {
  Settings settings;
  settings.zoom = 2;
  EXPECT_EQ(UserInterface(settings).settings().text(), settings.text());
}

}  // namespace
}  // namespace platon
