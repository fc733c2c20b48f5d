#include "client/ui/user_interface.h"

#include <gtest/gtest.h>

namespace platon::user_interface_test {
namespace {

using Kind = KeyEvent::Kind;

void tap(UserInterface& interface, Key key, int times = 1, bool menuOpen = false) {
  for (int i = 0; i < times; ++i) {
    interface.handle({key, Kind::kPress}, menuOpen);
    interface.handle({key, Kind::kRelease}, menuOpen);
  }
}

TEST(UserInterface, APressInTheMenuIsNoJumpAfterIt) {
  for (const Key key : {Key::kSpace, Key::kPadA}) {
    UserInterface interface { Settings() };
    interface.handle({key, Kind::kPress}, true);
    for (int tick = 0; tick < 10; ++tick) EXPECT_FALSE(interface.takeHeld(false).jump);
    interface.handle({key, Kind::kRelease}, false);
    EXPECT_FALSE(interface.takeHeld(false).jump);
    tap(interface, key);
    EXPECT_TRUE(interface.takeHeld(false).jump) << "the next press jumps again";
  }
}

TEST(UserInterface, AKeyTapShorterThanAFrameIsNotLost) {
  UserInterface interface { Settings() };
  tap(interface, Key::kSpace);
  EXPECT_TRUE(interface.takeHeld(false).jump);
  EXPECT_FALSE(interface.takeHeld(false).jump);
}

TEST(UserInterface, NoControlIsHeldWhileTheMenuIsOpen) {
  UserInterface interface { Settings() };
  interface.handle({Key::kArrowRight, Kind::kPress}, false);
  EXPECT_TRUE(interface.takeHeld(false).right);
  EXPECT_EQ(interface.takeHeld(true), HeldKeys());
  EXPECT_TRUE(interface.takeHeld(false).right) << "the key is still down";
}

TEST(UserInterface, AsksOnceForTheMenu) {
  for (const Key key : {Key::kEscape, Key::kPadStart}) {
    UserInterface interface { Settings() };
    EXPECT_FALSE(interface.takeMenu());
    tap(interface, key);
    EXPECT_TRUE(interface.takeMenu());
    EXPECT_FALSE(interface.takeMenu());
    tap(interface, key, 1, true);
    EXPECT_FALSE(interface.takeMenu()) << "in the menu the key belongs to the menu";
  }
}

TEST(UserInterface, F12AsksForThePictureEverywhere) {
  for (const bool menuOpen : {false, true}) {
    UserInterface interface { Settings() };
    tap(interface, Key::kF12, 1, menuOpen);
    EXPECT_TRUE(interface.takePicture());
    EXPECT_FALSE(interface.takePicture());
  }
}

TEST(UserInterface, ARestartIsHeldForOneTick) {
  UserInterface interface { Settings() };
  interface.restart();
  EXPECT_FALSE(interface.takeHeld(true).restart);
  EXPECT_TRUE(interface.takeHeld(false).restart);
  EXPECT_FALSE(interface.takeHeld(false).restart);
}

TEST(UserInterface, AGamepadIsLostIfItWasUsedLaterThanTheKeyboard) {
  UserInterface interface { Settings() };
  EXPECT_FALSE(interface.loseGamepad());
  tap(interface, Key::kPadA);
  EXPECT_EQ(interface.keyHints().of(Control::kJump), "pad A");
  EXPECT_TRUE(interface.loseGamepad());
  EXPECT_EQ(interface.keyHints().of(Control::kJump), "Space");
  EXPECT_FALSE(interface.loseGamepad());
  tap(interface, Key::kPadA);
  tap(interface, Key::kJ);
  EXPECT_FALSE(interface.loseGamepad()) << "the player plays with the keyboard";
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
  tap(interface, Key::kV, 1, true);
  EXPECT_FALSE(interface.takeVote());
}

TEST(UserInterface, EnterAsksToGoOnWhileTheMenuIsClosed) {
  UserInterface interface { Settings() };
  tap(interface, Key::kEnter);
  EXPECT_TRUE(interface.takeGoOn());
  EXPECT_FALSE(interface.takeGoOn());
  tap(interface, Key::kEnter, 1, true);
  EXPECT_FALSE(interface.takeGoOn());
}

TEST(UserInterface, ThePlayerTalksWhileTheMenuIsClosed) {
  UserInterface interface { Settings() };
  tap(interface, Key::kT);
  EXPECT_TRUE(interface.takeSay());
  EXPECT_FALSE(interface.takeSay());
  tap(interface, Key::kT, 1, true);
  EXPECT_FALSE(interface.takeSay());
}

TEST(UserInterface, StartsWithTheGivenSettings) {
  Settings settings;
  settings.zoom = 2;
  EXPECT_EQ(UserInterface(settings).settings().text(), settings.text());
}

}  // namespace
}  // namespace platon::user_interface_test
