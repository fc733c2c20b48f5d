#include "client/gl/window.h"

#include <bitset>
#include <cstddef>

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include "client/ui/controls/key_names.h"

namespace platon::glfw_keys_test {
namespace {

TEST(GlfwKeys, EachKeyOfTheKeyboardHasOneOfGlfw) {
  std::bitset<kKeyCount> found;
  for (int glfwKey = 0; glfwKey <= GLFW_KEY_LAST; ++glfwKey) {
    if (const std::optional<Key> key = keyOfGlfw(glfwKey)) found.set(static_cast<std::size_t>(*key));
  }
  for (std::size_t i = 0; i < kKeyCount; ++i) {
    const auto key = static_cast<Key>(i);
    EXPECT_EQ(found[i], !isOfGamepad(key)) << shownNameOf(key);
  }
  EXPECT_FALSE(keyOfGlfw(GLFW_KEY_UNKNOWN));
}

TEST(GlfwKeys, LettersDigitsAndFunctionKeysAreThemselves) {
  EXPECT_EQ(keyOfGlfw(GLFW_KEY_A), Key::kA);
  EXPECT_EQ(keyOfGlfw(GLFW_KEY_Q), Key::kQ);
  EXPECT_EQ(keyOfGlfw(GLFW_KEY_Z), Key::kZ);
  EXPECT_EQ(keyOfGlfw(GLFW_KEY_7), Key::kDigit7);
  EXPECT_EQ(keyOfGlfw(GLFW_KEY_KP_7), Key::kKeypad7);
  EXPECT_EQ(keyOfGlfw(GLFW_KEY_F1), Key::kF1);
  EXPECT_EQ(keyOfGlfw(GLFW_KEY_F10), Key::kF10);
  EXPECT_EQ(keyOfGlfw(GLFW_KEY_F12), Key::kF12);
  EXPECT_FALSE(keyOfGlfw(GLFW_KEY_F13));
}

TEST(GlfwKeys, ATriggerIsPressedFromHalfItsWay) {
  GLFWgamepadstate pad{};
  pad.axes[GLFW_GAMEPAD_AXIS_LEFT_TRIGGER] = -1;
  pad.axes[GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER] = 0.1F;
  EXPECT_FALSE(gamepadOfGlfw(pad).leftTrigger);
  EXPECT_TRUE(gamepadOfGlfw(pad).rightTrigger);
}

}  // namespace
}  // namespace platon::glfw_keys_test
