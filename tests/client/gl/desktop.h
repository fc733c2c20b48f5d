#pragma once

#include <chrono>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <thread>

namespace platon {

/// Runs xdotool, which sends real X events and requests to the window manager. Throws std::runtime_error if it fails.
inline void xdotool(const std::string& arguments) {
  if (std::system(("xdotool " + arguments).c_str()) != 0) throw std::runtime_error("xdotool " + arguments + " failed");
}

/// Calls `update` until `done` returns true, for at most 20 seconds. Returns whether `done` did.
template <class Update, class Done>
bool updateUntil(Update update, Done done) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (!done()) {
    if (std::chrono::steady_clock::now() > end) return false;
    update();
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

}  // namespace platon
