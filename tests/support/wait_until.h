#pragma once

#include <chrono>
#include <thread>

namespace platon {

/// Calls `step` every 2 ms until `done` returns true, for at most a minute. Returns whether `done` did.
template <class Step, class Done>
bool stepUntil(Step step, Done done) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (!done()) {
    if (std::chrono::steady_clock::now() > end) return false;
    step();
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

/// Waits until `done` returns true, for at most a minute. Returns whether it did.
template <class Done>
bool waitUntil(Done done) {
  return stepUntil([] {}, done);
}

}  // namespace platon
