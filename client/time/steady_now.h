#pragma once

#include <chrono>
#include <thread>

#include "client/time/clock.h"

namespace platon {

/// The system's monotonic clock. Only programs and tests may use it.
inline Clock steadyClock() {
  using Steady = std::chrono::steady_clock;
  return {[] { return std::chrono::duration_cast<Moment>(Steady::now().time_since_epoch()); },
          [](Moment moment) { std::this_thread::sleep_until(Steady::time_point(moment)); }};
}

}  // namespace platon
