#include "platon/game/input.h"

#include <gtest/gtest.h>

namespace platon {
namespace {

TEST(InputTest, EveryButtonHasABitOfItsOwn) {
  int bits = 0;
  for (const std::uint8_t button :
       {Input::kLeft, Input::kRight, Input::kJump, Input::kDown, Input::kRestart, Input::kPresent}) {
    EXPECT_TRUE(Input{button}.has(button));
    EXPECT_FALSE(Input{static_cast<std::uint8_t>(Input::kAll & ~button)}.has(button));
    bits += button;
  }
  EXPECT_EQ(bits, Input::kAll);
}

TEST(InputTest, AValidInputIsEmptyOrOfAPresentPlayerWithKnownButtons) {
  int valid = 0;
  for (int byte = 0; byte < 256; ++byte) {
    const bool known = (byte & ~int{Input::kAll}) == 0;
    const bool present = (byte & int{Input::kPresent}) != 0;
    EXPECT_EQ(isInput(Input{static_cast<std::uint8_t>(byte)}), byte == 0 || (known && present)) << byte;
    valid += isInput(Input{static_cast<std::uint8_t>(byte)});
  }
  EXPECT_EQ(valid, 33) << "none, and the 32 sets of buttons of a present player";
}

}  // namespace
}  // namespace platon
