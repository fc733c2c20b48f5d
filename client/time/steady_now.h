#pragma once

#include <chrono>
#include <thread>

#include "client/time/clock.h"

namespace platon {

/// The machine's monotonic clock; for the programs only.
inline Clock steadyClock() {
  using Steady = std::chrono::steady_clock;
  return {[] { return std::chrono::duration_cast<Moment>(Steady::now().time_since_epoch()); },
          [](Moment moment) { std::this_thread::sleep_until(Steady::time_point(moment)); }};
}

}  // namespace platon
