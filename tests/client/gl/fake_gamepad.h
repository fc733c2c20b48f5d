#pragma once

#include <optional>

#include <GLFW/glfw3.h>

namespace platon {

/// The state of the first gamepad that GLFW reports in a program that links fake_gamepad.cpp; none: not connected.
inline std::optional<GLFWgamepadstate> fakeGamepad;

}  // namespace platon
