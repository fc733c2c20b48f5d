#include "tests/client/gl/fake_gamepad.h"

// These definitions take precedence over those of the shared library.
extern "C" {

int glfwJoystickIsGamepad(int joystick) {
  return joystick == GLFW_JOYSTICK_1 && platon::fakeGamepad ? GLFW_TRUE : GLFW_FALSE;
}

int glfwGetGamepadState(int joystick, GLFWgamepadstate* state) {
  if (glfwJoystickIsGamepad(joystick) == GLFW_FALSE) return GLFW_FALSE;
  *state = *platon::fakeGamepad;
  return GLFW_TRUE;
}

}  // extern "C"
