#include "client/ui/user_interface.h"

#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace platon::user_interface_test {
namespace {

using Kind = KeyEvent::Kind;

// Returns what the press asks for.
std::optional<Action> tap(UserInterface& interface, Key key, bool menuOpen = false) {
  const std::optional<Action> action = interface.handle({key, Kind::kPress}, menuOpen);
  EXPECT_EQ(interface.handle({key, Kind::kRelease}, menuOpen), std::nullopt);
  return action;
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
    EXPECT_EQ(tap(interface, key), Action::kOpenMenu);
    EXPECT_EQ(tap(interface, key, true), std::nullopt) << "in the menu the key belongs to the menu";
  }
}

TEST(UserInterface, F12AsksForThePictureEverywhere) {
  for (const bool menuOpen : {false, true}) {
    UserInterface interface { Settings() };
    EXPECT_EQ(tap(interface, Key::kF12, menuOpen), Action::kTakePicture);
  }
}

TEST(UserInterface, ARestartIsHeldForOneTick) {
  UserInterface interface { Settings() };
  interface.restart();
  EXPECT_FALSE(interface.takeHeld(true).restart);
  EXPECT_TRUE(interface.takeHeld(false).restart);
  EXPECT_FALSE(interface.takeHeld(false).restart);
}

KeyEvent padEvent(Key key, int pad, Kind kind = Kind::kPress) { return {.key = key, .kind = kind, .pad = pad}; }

TEST(UserInterface, F2GivesTheArrowsToAnotherPlayerAndTakesThemBack) {
  UserInterface interface { Settings() };
  EXPECT_EQ(interface.keyHints().of(Control::kLeft), "←");
  EXPECT_EQ(tap(interface, Key::kF2), Action::kJoin);
  EXPECT_EQ(interface.deviceChange(), DeviceChange::kJoined);
  EXPECT_TRUE(interface.devices().has(1));
  EXPECT_EQ(interface.keyHints().of(Control::kLeft), "A");
  EXPECT_EQ(interface.keyHints().look(), "Hold Tab and press A D");
  EXPECT_EQ(interface.companionKeyHints(1).of(Control::kLeft), "←");
  interface.handle({Key::kArrowLeft, Kind::kPress}, false);
  interface.handle({Key::kD, Kind::kPress}, false);
  const HeldKeys first = interface.takeHeld(false);
  const HeldKeys second = interface.takeHeld(false, 1);
  EXPECT_TRUE(first.right && !first.left);
  EXPECT_TRUE(second.left && !second.right);
  EXPECT_EQ(tap(interface, Key::kF2), Action::kJoin);
  EXPECT_EQ(interface.deviceChange(), DeviceChange::kLeft);
  EXPECT_EQ(interface.takeHeld(false), first) << "a key that changes hands is not held, and the others are";
  interface.handle({Key::kArrowLeft, Kind::kRelease}, false);
  interface.handle({Key::kArrowLeft, Kind::kPress}, false);
  EXPECT_TRUE(interface.takeHeld(false).left);
}

TEST(UserInterface, AGamepadJoinsAndLeavesWithItsTrigger) {
  UserInterface interface { Settings() };
  for (const int pad : {4, 2, 0}) {
    EXPECT_EQ(interface.handle(padEvent(Key::kPadRightTrigger, pad), false), Action::kJoin);
    EXPECT_EQ(interface.deviceChange(), DeviceChange::kJoined);
  }
  EXPECT_EQ(interface.handle(padEvent(Key::kPadRightTrigger, 7), false), Action::kJoin);
  EXPECT_EQ(interface.deviceChange(), DeviceChange::kNone) << "four at most";
  EXPECT_EQ(interface.companionKeyHints(3).of(Control::kJump), "pad A");
  EXPECT_EQ(tap(interface, Key::kF2), Action::kJoin);
  EXPECT_EQ(interface.deviceChange(), DeviceChange::kNone);
  interface.handle(padEvent(Key::kPadLeft, 4), false);
  interface.handle(padEvent(Key::kPadA, 2), false);
  interface.handle(padEvent(Key::kPadRight, 7), false);
  EXPECT_TRUE(interface.takeHeld(false, 1).left);
  EXPECT_TRUE(interface.takeHeld(false, 2).jump);
  EXPECT_EQ(interface.takeHeld(false, 3), HeldKeys());
  EXPECT_TRUE(interface.takeHeld(false).right) << "a gamepad that has not joined is that of the first player";
  interface.handle(padEvent(Key::kPadRightTrigger, 2), false);
  EXPECT_EQ(interface.deviceChange(), DeviceChange::kLeft);
  EXPECT_FALSE(interface.devices().has(2));
  EXPECT_TRUE(interface.devices().has(3));
}

// Whoever joined or left stopped all balls.
TEST(UserInterface, WhoJoinsOrLeavesStopsNobodyElse) {
  UserInterface interface { Settings() };
  for (const int pad : {1, 2}) interface.handle(padEvent(Key::kPadRightTrigger, pad), false);
  interface.handle(padEvent(Key::kPadRight, 0), false);  // of the first player
  interface.handle(padEvent(Key::kPadLeft, 1), false);
  interface.handle(padEvent(Key::kPadA, 2), false);
  const auto allRun = [&] {
    return interface.takeHeld(false).right && interface.takeHeld(false, 1).left && interface.takeHeld(false, 2).jump;
  };
  ASSERT_TRUE(allRun());
  for (const DeviceChange change : {DeviceChange::kJoined, DeviceChange::kLeft, DeviceChange::kJoined}) {
    interface.handle(padEvent(Key::kPadRightTrigger, 3), false);
    EXPECT_EQ(interface.deviceChange(), change);
    EXPECT_TRUE(allRun());
  }
  tap(interface, Key::kF2);
  EXPECT_EQ(interface.deviceChange(), DeviceChange::kNone);
  EXPECT_TRUE(allRun());
  interface.handle(padEvent(Key::kPadRightTrigger, 1), false);
  EXPECT_EQ(interface.takeHeld(false, 1), HeldKeys());
  EXPECT_FALSE(interface.takeHeld(false).left) << "it has to be pressed anew";
  interface.handle(padEvent(Key::kPadLeft, 1, Kind::kRelease), false);
  EXPECT_TRUE(interface.takeHeld(false).right);
}

TEST(UserInterface, ATriggerThatAControlHasDoesNotJoin) {
  Settings settings;
  settings.bindings.bind(Control::kJump, Key::kPadRightTrigger);
  UserInterface interface(settings);
  EXPECT_EQ(tap(interface, Key::kPadRightTrigger), std::nullopt);
  EXPECT_TRUE(interface.takeHeld(false).jump);
}

TEST(UserInterface, TheMenuLetsNobodyJoin) {
  UserInterface interface { Settings() };
  EXPECT_EQ(tap(interface, Key::kF2, true), std::nullopt);
  EXPECT_EQ(tap(interface, Key::kPadRightTrigger, true), std::nullopt);
  EXPECT_FALSE(interface.devices().has(1));
}

TEST(UserInterface, ACompanionWhoseGamepadIsLostWaitsForAnother) {
  UserInterface interface { Settings() };
  interface.handle(padEvent(Key::kPadRightTrigger, 1), false);
  interface.handle(padEvent(Key::kPadRightTrigger, 2), false);
  EXPECT_TRUE(interface.loseGamepad(1));
  EXPECT_TRUE(interface.devices().has(1));
  interface.handle(padEvent(Key::kPadRightTrigger, 5), false);
  EXPECT_EQ(interface.deviceChange(), DeviceChange::kReturned);
  interface.handle(padEvent(Key::kPadRight, 5), false);
  EXPECT_TRUE(interface.takeHeld(false, 1).right);
}

// Both have the same button down, and one lets it go.
TEST(UserInterface, TwoGamepadsOfOnePlayerActAsOne) {
  UserInterface interface { Settings() };
  interface.handle(padEvent(Key::kPadLeft, 0), false);
  interface.handle(padEvent(Key::kPadLeft, 1), false);
  interface.handle(padEvent(Key::kPadLeft, 0, Kind::kRelease), false);
  interface.takeHeld(false);
  EXPECT_TRUE(interface.takeHeld(false).left);
  interface.handle(padEvent(Key::kPadLeft, 1, Kind::kRelease), false);
  EXPECT_FALSE(interface.takeHeld(false).left);
}

TEST(UserInterface, AGamepadIsLostIfItWasUsedLaterThanTheKeyboard) {
  UserInterface interface { Settings() };
  EXPECT_FALSE(interface.loseGamepad(0));
  tap(interface, Key::kPadA);
  EXPECT_EQ(interface.keyHints().of(Control::kJump), "pad A");
  EXPECT_TRUE(interface.loseGamepad(0));
  EXPECT_EQ(interface.keyHints().of(Control::kJump), "Space");
  EXPECT_FALSE(interface.loseGamepad(0));
  tap(interface, Key::kPadA);
  tap(interface, Key::kJ);
  EXPECT_FALSE(interface.loseGamepad(0)) << "the player plays with the keyboard";
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

// Before, F1 in a menu switched on the help, which was seen only when the game began.
TEST(UserInterface, InAMenuWhichShowsNeitherHelpNorGraphTheirKeysChangeNothing) {
  UserInterface interface { Settings() };
  tap(interface, Key::kF1, true);
  EXPECT_FALSE(interface.helpShown());
  tap(interface, Key::kF3, true);
  EXPECT_FALSE(interface.settings().netGraph);
}

TEST(UserInterface, ThePlayerVotesGoesOnAndTalksWhileTheMenuIsClosed) {
  UserInterface interface { Settings() };
  const std::vector<std::pair<Key, Action>> actions{
      {Key::kV, Action::kToggleVote}, {Key::kEnter, Action::kGoOn}, {Key::kT, Action::kSay}};
  for (const auto& [key, action] : actions) {
    EXPECT_EQ(tap(interface, key), action);
    EXPECT_EQ(tap(interface, key, true), std::nullopt);
  }
}

TEST(UserInterface, StartsWithTheGivenSettings) {
  Settings settings;
  settings.zoom = 2;
  EXPECT_EQ(UserInterface(settings).settings().text(), settings.text());
}

}  // namespace
}  // namespace platon::user_interface_test
