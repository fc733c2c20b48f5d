#pragma once

#include <cstdlib>
#include <stdexcept>
#include <string>

namespace platon {

/// Runs xdotool, which sends real X events and requests to the window manager. Throws std::runtime_error if it fails.
inline void xdotool(const std::string& arguments) {
  if (std::system(("xdotool " + arguments).c_str()) != 0) throw std::runtime_error("xdotool " + arguments + " failed");
}

}  // namespace platon
