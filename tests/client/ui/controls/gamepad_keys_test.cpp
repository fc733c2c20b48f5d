#include "client/ui/controls/gamepad_keys.h"

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace platon::gamepad_keys_test {
namespace {

using std::chrono::milliseconds;

using Kind = KeyEvent::Kind;
using Events = std::vector<KeyEvent>;

GamepadState stickAt(float x, float y) {
  GamepadState state;
  state.stickX = x;
  state.stickY = y;
  return state;
}

Events update(GamepadKeys& keys, const GamepadState& state) { return keys.update(std::array{state}); }

using Pads = std::vector<int>;

TEST(GamepadKeys, OnlyGamepadsThatWereUsedAreLost) {
  GamepadKeys keys;
  GamepadState first;
  GamepadState second;
  second.id = 1;
  keys.update({});
  keys.update(std::array{first, second});
  keys.update(std::array{second});
  EXPECT_EQ(keys.takeLost(), Pads()) << "never used";
  second.a = true;
  keys.update(std::array{first, second});
  second.a = false;
  keys.update(std::array{first, second});
  keys.update(std::array{second});
  EXPECT_EQ(keys.takeLost(), Pads()) << "the other one was used";
  keys.update(std::array{first});
  EXPECT_EQ(keys.takeLost(), Pads{1});
  EXPECT_EQ(keys.takeLost(), Pads());
  keys.update({});
  EXPECT_EQ(keys.takeLost(), Pads());
}

TEST(GamepadKeys, FourGamepadsThatAreUnpluggedInTurnAreLostOneByOne) {
  GamepadKeys keys;
  std::vector<GamepadState> pads(4);
  for (int i = 0; i < 4; ++i) {
    pads[static_cast<std::size_t>(i)].id = i;
    pads[static_cast<std::size_t>(i)].stickX = 1;
  }
  keys.update(pads);
  for (int i = 0; i < 4; ++i) {
    pads.erase(pads.begin());
    EXPECT_EQ(keys.update(pads), (Events{{.key = Key::kPadRight, .kind = Kind::kRelease, .pad = i}}));
    EXPECT_EQ(keys.takeLost(), Pads{i});
  }
}

TEST(GamepadKeys, AGamepadThatIsConnectedAgainIsLostAgain) {
  GamepadKeys keys;
  GamepadState pad;
  pad.stickX = 1;
  for (int i = 0; i < 2; ++i) {
    EXPECT_FALSE(update(keys, pad).empty());
    const Events released = keys.update({});
    ASSERT_EQ(released.size(), 1u);
    EXPECT_EQ(released[0], (KeyEvent{Key::kPadRight, Kind::kRelease}));
    EXPECT_EQ(keys.takeLost(), Pads{0});
  }
}

TEST(GamepadKeys, EveryButtonIsPressedAndReleasedOnce) {
  constexpr std::array<std::pair<bool GamepadState::*, Key>, 16> kButtons{
      {{&GamepadState::dpadLeft, Key::kPadLeft},
       {&GamepadState::dpadRight, Key::kPadRight},
       {&GamepadState::dpadUp, Key::kPadUp},
       {&GamepadState::dpadDown, Key::kPadDown},
       {&GamepadState::a, Key::kPadA},
       {&GamepadState::b, Key::kPadB},
       {&GamepadState::x, Key::kPadX},
       {&GamepadState::y, Key::kPadY},
       {&GamepadState::start, Key::kPadStart},
       {&GamepadState::back, Key::kPadBack},
       {&GamepadState::leftBumper, Key::kPadLeftBumper},
       {&GamepadState::rightBumper, Key::kPadRightBumper},
       {&GamepadState::leftTrigger, Key::kPadLeftTrigger},
       {&GamepadState::rightTrigger, Key::kPadRightTrigger},
       {&GamepadState::leftStick, Key::kPadLeftStick},
       {&GamepadState::rightStick, Key::kPadRightStick}}};
  for (const auto& [button, key] : kButtons) {
    GamepadKeys keys;
    GamepadState state;
    state.*button = true;
    EXPECT_EQ(update(keys, state), (Events{{key, Kind::kPress}}));
    EXPECT_EQ(update(keys, state), Events());
    EXPECT_EQ(update(keys, {}), (Events{{key, Kind::kRelease}}));
    EXPECT_EQ(update(keys, {}), Events());
  }
}

TEST(GamepadKeys, TheStickPressesItsDirectionBeyondTheDeadZone) {
  constexpr float kBeyond = GamepadKeys::kVerticalDeadZone + 0.01F;
  const std::array<std::pair<GamepadState, Key>, 4> directions{{{stickAt(-1, 0), Key::kPadLeft},
                                                                {stickAt(1, 0), Key::kPadRight},
                                                                {stickAt(0, -kBeyond), Key::kPadUp},
                                                                {stickAt(0, kBeyond), Key::kPadDown}}};
  for (const auto& [state, key] : directions) {
    GamepadKeys keys;
    EXPECT_EQ(update(keys, state), (Events{{key, Kind::kPress}}));
  }
  GamepadKeys keys;
  const float edge = GamepadKeys::kDeadZone;
  for (const GamepadState& state : {stickAt(edge, edge), stickAt(-edge, -edge)})
    EXPECT_EQ(update(keys, state), Events());
}

TEST(GamepadKeys, TheRightStickTurnsTheView) {
  constexpr float kBeyond = GamepadKeys::kLookDeadZone + 0.01F;
  constexpr std::array<std::pair<float GamepadState::*, std::pair<Key, Key>>, 2> kAxes{
      {{&GamepadState::lookX, {Key::kPadLookLeft, Key::kPadLookRight}},
       {&GamepadState::lookY, {Key::kPadLookUp, Key::kPadLookDown}}}};
  for (const auto& [axis, directions] : kAxes) {
    GamepadKeys keys;
    GamepadState state;
    state.*axis = -kBeyond;
    EXPECT_EQ(update(keys, state), (Events{{directions.first, Kind::kPress}}));
    state.*axis = GamepadKeys::kLookDeadZone;
    EXPECT_EQ(update(keys, state), (Events{{directions.first, Kind::kRelease}}));
    state.*axis = kBeyond;
    EXPECT_EQ(update(keys, state), (Events{{directions.second, Kind::kPress}}));
  }
}

TEST(GamepadKeys, TheTiltOfTheStickChoosesTheSpeed) {
  GamepadKeys keys;
  EXPECT_EQ(update(keys, stickAt(-GamepadKeys::kCreep, 0)),
            (Events{{Key::kPadLeft, Kind::kPress}, {Key::kPadCreep, Kind::kPress}}));
  EXPECT_EQ(update(keys, stickAt(-GamepadKeys::kWalk, 0)),
            (Events{{Key::kPadWalk, Kind::kPress}, {Key::kPadCreep, Kind::kRelease}}));
  EXPECT_EQ(update(keys, stickAt(-1, 0)), (Events{{Key::kPadWalk, Kind::kRelease}}));
  GamepadState pad = stickAt(-GamepadKeys::kCreep, 0);
  pad.dpadLeft = true;
  EXPECT_EQ(update(keys, pad), Events()) << "the directional pad runs";
}

TEST(GamepadKeys, StickAndDirectionalPadAreOneKey) {
  GamepadKeys keys;
  GamepadState both = stickAt(-1, 0);
  both.dpadLeft = true;
  EXPECT_EQ(update(keys, both), (Events{{Key::kPadLeft, Kind::kPress}}));
  EXPECT_EQ(update(keys, stickAt(-1, 0)), Events());
  EXPECT_EQ(update(keys, {}), (Events{{Key::kPadLeft, Kind::kRelease}}));
}

TEST(GamepadKeys, EachGamepadHasItsOwnKeys) {
  GamepadKeys keys;
  GamepadState first;
  first.a = true;
  GamepadState second = first;
  second.id = 3;
  const auto event = [](Kind kind, int pad) { return KeyEvent{.key = Key::kPadA, .kind = kind, .pad = pad}; };
  EXPECT_EQ(keys.update(std::array{first, second}), (Events{event(Kind::kPress, 0), event(Kind::kPress, 3)}));
  first.a = false;
  EXPECT_EQ(keys.update(std::array{first, second}), (Events{event(Kind::kRelease, 0)}));
}

TEST(GamepadKeys, ADisconnectedGamepadReleasesItsKeys) {
  GamepadKeys keys;
  update(keys, stickAt(1, 0));
  EXPECT_EQ(keys.update({}), (Events{{Key::kPadRight, Kind::kRelease}}));
}

constexpr std::size_t kNone = 0;

class PadRepeatTest : public testing::Test {
 protected:
  // Repetitions of `key` in so many milliseconds, with a picture in each of them.
  std::size_t repeatsOf(Key key, int duration) {
    std::size_t count = 0;
    for (int i = 0; i < duration; ++i) {
      now_ += milliseconds(1);
      const std::optional<KeyEvent> event = repeat_.repeat(true, now_);
      if (!event) continue;
      EXPECT_EQ(*event, (KeyEvent{key, Kind::kRepeat}));
      ++count;
    }
    return count;
  }
  // Whether a repetition is due at once.
  bool take(const KeyEvent& event, bool repeats = true) {
    repeat_.observe(event, now_);
    return repeat_.repeat(repeats, now_).has_value();
  }

  PadRepeat repeat_;
  Time now_{};
};

TEST_F(PadRepeatTest, EachDirectionIsRepeatedAfter400MsAndThenEvery80Ms) {
  for (const Key key : {Key::kPadLeft, Key::kPadRight, Key::kPadUp, Key::kPadDown}) {
    EXPECT_FALSE(take({key, Kind::kPress}));
    EXPECT_EQ(repeatsOf(key, 399), kNone);
    EXPECT_EQ(repeatsOf(key, 1), 1U);
    EXPECT_EQ(repeatsOf(key, 79), kNone);
    EXPECT_EQ(repeatsOf(key, 1), 1U);
    EXPECT_EQ(repeatsOf(key, 800), 10U);
    take({key, Kind::kRelease});
    EXPECT_EQ(repeatsOf(key, 1000), kNone);
  }
}

TEST_F(PadRepeatTest, OtherButtonsAndKeysAreNotRepeated) {
  for (const Key key : {Key::kPadA, Key::kPadWalk, Key::kPadLookLeft, Key::kArrowDown}) {
    take({key, Kind::kPress});
    EXPECT_EQ(repeatsOf(key, 1000), kNone);
  }
}

TEST_F(PadRepeatTest, TheDirectionThatWasPressedLastIsRepeated) {
  take({Key::kPadDown, Kind::kPress});
  take({Key::kPadRight, Kind::kPress});
  EXPECT_EQ(repeatsOf(Key::kPadRight, 480), 2U);
  take({Key::kPadDown, Kind::kRelease});
  EXPECT_EQ(repeatsOf(Key::kPadRight, 80), 1U);
}

TEST_F(PadRepeatTest, ADirectionThatMovedTheBallIsNotRepeatedInTheMenu) {
  take({Key::kPadDown, Kind::kPress}, false);
  EXPECT_EQ(repeatsOf(Key::kPadDown, 1000), kNone);
}

TEST_F(PadRepeatTest, ALatePictureGetsOneRepetition) {
  take({Key::kPadDown, Kind::kPress});
  now_ += milliseconds(1000);
  EXPECT_TRUE(repeat_.repeat(true, now_));
  EXPECT_FALSE(repeat_.repeat(true, now_));
  EXPECT_EQ(repeatsOf(Key::kPadDown, 80), 1U);
}

}  // namespace
}  // namespace platon::gamepad_keys_test
