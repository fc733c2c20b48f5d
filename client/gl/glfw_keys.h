#pragma once

#include <optional>

#include "client/ui/controls/gamepad_state.h"
#include "client/ui/key.h"

struct GLFWgamepadstate;

namespace platon {

/// The key that GLFW names `glfwKey`; nothing if the client does not use it.
std::optional<Key> keyOfGlfw(int glfwKey);

/// The state of a gamepad as GLFW reports it. A trigger is pressed from half its way.
GamepadState gamepadOfGlfw(const GLFWgamepadstate& glfwState);

}  // namespace platon
