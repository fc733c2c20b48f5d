#include "platon/game/input.h"

#include <gtest/gtest.h>

namespace platon::input_test {
namespace {

constexpr bool both(int byte, int buttons) { return (byte & buttons) == buttons; }

TEST(InputTest, EveryButtonHasABitOfItsOwn) {
  int bits = 0;
  for (const std::uint8_t button : {Input::kLeft, Input::kRight, Input::kJump, Input::kDown, Input::kRestart,
                                    Input::kWalk, Input::kCreep, Input::kPresent}) {
    EXPECT_TRUE(Input{button}.has(button));
    EXPECT_FALSE(Input{static_cast<std::uint8_t>(0xff & ~button)}.has(button));
    bits += button;
  }
  EXPECT_EQ(bits, 0xff);
}

TEST(InputTest, AValidInputIsEmptyOrOfAPresentPlayerWithOneDirectionAndItsSpeed) {
  int valid = 0;
  for (int byte = 0; byte < 256; ++byte) {
    const bool speedWithoutDirection = (byte & Input::kSpeeds) != 0 && (byte & Input::kDirections) == 0;
    const bool good = both(byte, Input::kPresent) && !both(byte, Input::kDirections) && !both(byte, Input::kSpeeds) &&
                      !speedWithoutDirection;
    EXPECT_EQ(isInput(Input{static_cast<std::uint8_t>(byte)}), byte == 0 || good) << byte;
    valid += isInput(Input{static_cast<std::uint8_t>(byte)});
  }
  EXPECT_EQ(valid, 1 + 7 * 8) << "none, and 7 ways to move with each set of jump, down and restart";
}

TEST(InputTest, AnyButtonsGiveAValidInputThatKeepsWhatIsValid) {
  for (int byte = 0; byte < 256; ++byte) {
    const Input input{static_cast<std::uint8_t>(byte)};
    const Input valid = validInput(input.buttons);
    EXPECT_TRUE(isInput(valid)) << byte;
    EXPECT_EQ(valid.buttons & ~byte, 0) << "presses nothing more";
    if (isInput(input)) {
      EXPECT_EQ(valid, input);
    }
  }
  const auto buttonsOf = [](int buttons) {
    return validInput(static_cast<std::uint8_t>(buttons | Input::kPresent)).buttons & 0x7f;
  };
  EXPECT_EQ(buttonsOf(Input::kLeft | Input::kRight | Input::kWalk | Input::kJump), Input::kJump);
  EXPECT_EQ(buttonsOf(Input::kLeft | Input::kWalk | Input::kCreep), Input::kLeft | Input::kCreep);
}

}  // namespace
}  // namespace platon::input_test
