#include "client/ui/controls/input_mapper.h"

#include <array>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>

#include <gtest/gtest.h>

namespace platon::input_mapper_test {
namespace {

using Kind = KeyEvent::Kind;

void press(InputMapper& mapper, Key key, bool menuOpen = false) { mapper.handle({key, Kind::kPress}, menuOpen); }
void release(InputMapper& mapper, Key key, bool menuOpen = false) { mapper.handle({key, Kind::kRelease}, menuOpen); }

HeldKeys only(bool HeldKeys::*control) {
  HeldKeys held;
  held.*control = true;
  return held;
}

// The control of the game that a key holds; none for keys of the user interface.
bool HeldKeys::*controlOf(Key key) {
  switch (key) {
    case Key::kArrowLeft:
    case Key::kA:
    case Key::kPadLeft:
      return &HeldKeys::left;
    case Key::kArrowRight:
    case Key::kD:
    case Key::kPadRight:
      return &HeldKeys::right;
    case Key::kArrowUp:
    case Key::kW:
      return &HeldKeys::up;
    case Key::kArrowDown:
    case Key::kS:
    case Key::kPadDown:
      return &HeldKeys::down;
    case Key::kSpace:
    case Key::kPadA:
      return &HeldKeys::jump;
    case Key::kPadWalk:
      return &HeldKeys::walk;
    case Key::kShift:
    case Key::kPadLeftBumper:
    case Key::kPadCreep:
      return &HeldKeys::creep;
    case Key::kR:
    case Key::kPadBack:
      return &HeldKeys::restart;
    default:
      return nullptr;
  }
}

TEST(InputMapper, EveryKeyHoldsItsControlUntilItIsReleased) {
  for (std::size_t i = 0; i < kKeyCount; ++i) {
    const Key key = static_cast<Key>(i);
    bool HeldKeys::*const control = controlOf(key);
    const HeldKeys expected = control == nullptr ? HeldKeys() : only(control);
    InputMapper mapper;
    press(mapper, key);
    for (int tick = 0; tick < 3; ++tick) EXPECT_EQ(mapper.takeHeld(), expected) << i;
    release(mapper, key);
    EXPECT_EQ(mapper.takeHeld(), HeldKeys()) << i;
  }
}

TEST(InputMapper, AControlIsHeldWhileOneOfItsKeysIsHeld) {
  InputMapper mapper;
  press(mapper, Key::kArrowLeft);
  press(mapper, Key::kA);
  mapper.takeHeld();
  release(mapper, Key::kArrowLeft);
  EXPECT_EQ(mapper.takeHeld(), only(&HeldKeys::left));
  release(mapper, Key::kA);
  EXPECT_EQ(mapper.takeHeld(), HeldKeys());
}

TEST(InputMapper, AKeyTapShorterThanAFrameIsNotLost) {
  InputMapper mapper;
  press(mapper, Key::kSpace);
  release(mapper, Key::kSpace);
  EXPECT_EQ(mapper.takeHeld(), only(&HeldKeys::jump));
  EXPECT_EQ(mapper.takeHeld(), HeldKeys()) << "a tap lasts one tick";
}

TEST(InputMapper, ATapOverSeveralFramesWithoutATickIsNotLost) {
  InputMapper mapper;
  press(mapper, Key::kR);
  mapper.handle({Key::kR, Kind::kRepeat}, false);
  release(mapper, Key::kR);
  EXPECT_EQ(mapper.takeHeld(), only(&HeldKeys::restart));
  EXPECT_EQ(mapper.takeHeld(), HeldKeys());
}

TEST(InputMapper, AKeyPressedInTheMenuIsNotPassedToTheGameUntilItIsPressedAgain) {
  for (const Key key : {Key::kSpace, Key::kPadA, Key::kArrowLeft, Key::kR}) {
    InputMapper mapper;
    press(mapper, key, true);
    EXPECT_EQ(mapper.takeHeld(), HeldKeys()) << "the menu has just closed";
    mapper.handle({key, Kind::kRepeat}, false);
    EXPECT_EQ(mapper.takeHeld(), HeldKeys());
    release(mapper, key);
    EXPECT_EQ(mapper.takeHeld(), HeldKeys());
    press(mapper, key);
    EXPECT_NE(mapper.takeHeld(), HeldKeys());
  }
}

TEST(InputMapper, AKeyHeldSinceBeforeTheMenuIsStillHeldAfterIt) {
  InputMapper mapper;
  press(mapper, Key::kArrowRight);
  press(mapper, Key::kEscape);
  press(mapper, Key::kEscape, true);
  EXPECT_EQ(mapper.takeHeld(), only(&HeldKeys::right));
}

TEST(InputMapper, AKeyReleasedInTheMenuIsNotHeldAfterIt) {
  InputMapper mapper;
  press(mapper, Key::kArrowRight);
  release(mapper, Key::kArrowRight, true);
  EXPECT_EQ(mapper.takeHeld(), HeldKeys());
}

TEST(InputMapper, ATapBeforeTheMenuOpensIsNotPassedOnAfterIt) {
  InputMapper mapper;
  press(mapper, Key::kSpace);
  release(mapper, Key::kSpace);
  press(mapper, Key::kEscape);
  press(mapper, Key::kEscape, true);
  EXPECT_EQ(mapper.takeHeld(), HeldKeys());
}

TEST(InputMapper, WhileTabIsHeldTheDirectionsMoveTheViewAndNotThePlayer) {
  constexpr std::array<std::pair<Key, std::pair<int, int>>, 8> kDirections{{{Key::kArrowLeft, {-1, 0}},
                                                                            {Key::kA, {-1, 0}},
                                                                            {Key::kArrowRight, {1, 0}},
                                                                            {Key::kD, {1, 0}},
                                                                            {Key::kArrowUp, {0, 1}},
                                                                            {Key::kW, {0, 1}},
                                                                            {Key::kArrowDown, {0, -1}},
                                                                            {Key::kS, {0, -1}}}};
  for (const auto& [key, way] : kDirections) {
    InputMapper mapper;
    press(mapper, key);
    EXPECT_EQ(mapper.look(), LookInput());
    press(mapper, Key::kTab);
    EXPECT_EQ(mapper.look(), (LookInput{true, {way.first, way.second}}));
    EXPECT_EQ(mapper.takeHeld(), HeldKeys());
    release(mapper, Key::kTab);
    EXPECT_EQ(mapper.look(), LookInput());
    EXPECT_NE(mapper.takeHeld(), HeldKeys());
  }
}

TEST(InputMapper, TheRightStickMovesTheViewWhileThePlayerRuns) {
  InputMapper mapper;
  press(mapper, Key::kArrowLeft);
  press(mapper, Key::kPadLookRight);
  press(mapper, Key::kPadLookDown);
  EXPECT_EQ(mapper.look(), (LookInput{true, {1, -1}}));
  EXPECT_EQ(mapper.takeHeld(), only(&HeldKeys::left));
}

TEST(InputMapper, EnterGoesOnUnlessItChoosesInTheMenu) {
  EXPECT_EQ(InputMapper().handle({Key::kEnter, Kind::kPress}, false), Action::kGoOn);
  EXPECT_EQ(InputMapper().handle({Key::kEnter, Kind::kPress}, true), std::nullopt);
}

TEST(InputMapper, AHeldKeyVotesOnce) {
  InputMapper mapper;
  EXPECT_EQ(mapper.handle({Key::kV, Kind::kPress}, false), Action::kToggleVote);
  EXPECT_EQ(mapper.handle({Key::kV, Kind::kRepeat}, false), std::nullopt);
  EXPECT_EQ(mapper.handle({Key::kV, Kind::kRelease}, false), std::nullopt);
  EXPECT_EQ(InputMapper().handle({Key::kV, Kind::kPress}, true), std::nullopt);
}

TEST(InputMapper, AChosenKeyHoldsItsControlAndTheOldOneNothing) {
  Bindings bindings;
  bindings.clear(Control::kJump);
  bindings.bind(Control::kJump, Key::kV);
  InputMapper mapper;
  mapper.configure(bindings, {});
  EXPECT_EQ(mapper.handle({Key::kV, Kind::kPress}, false), std::nullopt) << "it votes no more";
  EXPECT_EQ(mapper.takeHeld(), only(&HeldKeys::jump));
  release(mapper, Key::kV);
  press(mapper, Key::kSpace);
  EXPECT_EQ(mapper.takeHeld(), HeldKeys());
}

TEST(InputMapper, AToggledControlIsOnFromOnePressToTheNext) {
  InputMapper mapper;
  const auto tap = [&mapper](Key key, bool menuOpen = false) {
    press(mapper, key, menuOpen);
    release(mapper, key, menuOpen);
  };
  mapper.configure({}, {.slow = true, .look = true});
  tap(Key::kShift);
  for (int tick = 0; tick < 3; ++tick) EXPECT_EQ(mapper.takeHeld(), only(&HeldKeys::creep));
  tap(Key::kShift, true);
  EXPECT_EQ(mapper.takeHeld(), only(&HeldKeys::creep)) << "keys in the menu toggle nothing";
  tap(Key::kShift);
  EXPECT_EQ(mapper.takeHeld(), HeldKeys());
  tap(Key::kTab);
  EXPECT_TRUE(mapper.look().held);
  tap(Key::kTab);
  EXPECT_FALSE(mapper.look().held);
}

TEST(InputMapper, WhoStopsTogglingHasNothingToggledOn) {
  InputMapper mapper;
  mapper.configure({}, {.slow = true});
  press(mapper, Key::kShift);
  release(mapper, Key::kShift);
  mapper.takeHeld();
  mapper.configure({}, {});
  EXPECT_EQ(mapper.takeHeld(), HeldKeys());
  mapper.configure({}, {.slow = true});
  EXPECT_EQ(mapper.takeHeld(), HeldKeys());
}

TEST(InputMapper, WhatIsTypedHoldsNothing) {
  InputMapper mapper;
  KeyEvent event;
  event.kind = Kind::kCharacter;
  event.character = U' ';
  EXPECT_EQ(mapper.handle(event, false), std::nullopt);
  EXPECT_EQ(mapper.takeHeld(), HeldKeys());
}

TEST(InputMapper, EWatchesAnotherPlayerInTheGameOnly) {
  EXPECT_EQ(InputMapper().handle({Key::kE}, false), Action::kWatchNext);
  EXPECT_EQ(InputMapper().handle({Key::kE}, true), std::nullopt);
}

TEST(InputMapper, EachEmoteHasAKeyInTheGame) {
  constexpr std::array kDigits{Key::kDigit1, Key::kDigit2, Key::kDigit3, Key::kDigit4};
  constexpr std::array kActions{Action::kEmote1, Action::kEmote2, Action::kEmote3, Action::kEmote4};
  for (std::size_t i = 0; i < kDigits.size(); ++i) {
    EXPECT_EQ(InputMapper().handle({kDigits[i]}, false), kActions[i]);
    EXPECT_EQ(InputMapper().handle({kDigits[i]}, true), std::nullopt);
  }
}

TEST(InputMapper, TTalksInTheGameOnly) {
  EXPECT_EQ(InputMapper().handle({Key::kT}, false), Action::kSay);
  EXPECT_EQ(InputMapper().handle({Key::kT}, true), std::nullopt);
}

TEST(InputMapper, EscapeAndStartOpenTheMenu) {
  for (const Key key : {Key::kEscape, Key::kPadStart}) {
    EXPECT_EQ(InputMapper().handle({key}, false), Action::kOpenMenu);
    EXPECT_EQ(InputMapper().handle({key}, true), std::nullopt) << "in the menu the key belongs to the menu";
  }
}

constexpr std::array<std::pair<KeyEvent, Action>, 4> kToggles{
    {{{Key::kF1}, Action::kToggleHelp},
     {{Key::kF3}, Action::kToggleNetGraph},
     {{Key::kF11}, Action::kToggleFullscreen},
     {{Key::kEnter, Kind::kPress, true}, Action::kToggleFullscreen}}};

TEST(InputMapper, TogglesActWithoutTheMenuAndThatOfTheFullScreenAlsoInIt) {
  for (const auto& [event, action] : kToggles) {
    const bool everywhere = action == Action::kToggleFullscreen;
    EXPECT_EQ(InputMapper().handle(event, false), action);
    EXPECT_EQ(InputMapper().handle(event, true), everywhere ? std::optional(action) : std::nullopt);
  }
}

TEST(InputMapper, ReleasesHaveNoAction) {
  for (std::size_t i = 0; i < kKeyCount; ++i) {
    const KeyEvent event{static_cast<Key>(i), Kind::kRelease};
    EXPECT_EQ(InputMapper().handle(event, true), std::nullopt) << i;
    EXPECT_EQ(InputMapper().handle(event, false), std::nullopt) << i;
  }
}

TEST(InputMapper, KeyRepeatHasNoAction) {
  for (auto [event, action] : kToggles) {
    event.kind = Kind::kRepeat;
    EXPECT_EQ(InputMapper().handle(event, false), std::nullopt);
  }
}

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

using Button = PointerEvent::Button;
using PointerKind = PointerEvent::Kind;

class MouseLookTest : public testing::Test {
 protected:
  void event(PointerKind kind, glm::dvec2 place, Button button = Button::kLeft) {
    PointerEvent pointer;
    pointer.kind = kind;
    pointer.place = place;
    pointer.button = button;
    look_.handle(pointer);
  }

  MouseLook look_;
};

TEST_F(MouseLookTest, TheSolidFollowsThePointerWhileTheRightButtonIsHeld) {
  event(PointerKind::kMove, {500, 300});
  EXPECT_EQ(look_.take({}), LookInput());
  event(PointerKind::kPress, {500, 300}, Button::kRight);
  event(PointerKind::kMove, {520, 300});
  event(PointerKind::kMove, {520, 290});
  const LookInput look = look_.take({});
  EXPECT_TRUE(look.held);
  EXPECT_DOUBLE_EQ(look.turn.x, -20 * MouseLook::kTurn) << "to the left of a solid that goes to the right";
  EXPECT_DOUBLE_EQ(look.turn.y, -10 * MouseLook::kTurn);
  EXPECT_EQ(look_.take({}).turn, glm::dvec2(0)) << "it was taken";
  event(PointerKind::kRelease, {520, 290}, Button::kRight);
  event(PointerKind::kMove, {600, 290});
  EXPECT_EQ(look_.take({}), LookInput());
}

TEST_F(MouseLookTest, OtherButtonsAndTheWheelDoNothing) {
  event(PointerKind::kPress, {0, 0}, Button::kLeft);
  event(PointerKind::kMove, {50, 0});
  event(PointerKind::kPress, {50, 0}, Button::kMiddle);
  event(PointerKind::kScroll, {50, 0});
  EXPECT_EQ(look_.take({}), LookInput());
}

TEST_F(MouseLookTest, ReleasedItWaitsForTheNextPress) {
  event(PointerKind::kPress, {0, 0}, Button::kRight);
  event(PointerKind::kMove, {50, 0});
  look_.release();
  event(PointerKind::kMove, {90, 0});
  EXPECT_EQ(look_.take({}), LookInput());
  event(PointerKind::kPress, {90, 0}, Button::kRight);
  EXPECT_TRUE(look_.take({}).held);
}

TEST_F(MouseLookTest, KeepsWhatKeysAndGamepadDo) {
  const LookInput keys{true, {1, 0}, {}};
  EXPECT_EQ(look_.take(keys), keys);
}

}  // namespace
}  // namespace platon::input_mapper_test
