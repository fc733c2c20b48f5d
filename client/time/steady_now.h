#pragma once

#include <chrono>
#include <ctime>
#include <thread>

#include "client/time/clock.h"
#include "protocol/time.h"

namespace platon {

/// The system's monotonic clock. Only programs and tests may use it.
inline Clock steadyClock() {
  using Steady = std::chrono::steady_clock;
  return {[] { return std::chrono::duration_cast<Time>(Steady::now().time_since_epoch()); },
          [](Time moment) { std::this_thread::sleep_until(Steady::time_point(moment)); }};
}

namespace intern {

inline Time readClock(clockid_t clock) {
  std::timespec time{};
  clock_gettime(clock, &time);
  return std::chrono::duration_cast<Time>(std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec));
}

}  // namespace intern

/// Time for which a processor has worked for the calling thread. Only programs and tests may use it.
inline Time threadTime() { return intern::readClock(CLOCK_THREAD_CPUTIME_ID); }

/// Time for which processors have worked for all threads of the program. Only programs and tests may use it.
inline Time programTime() { return intern::readClock(CLOCK_PROCESS_CPUTIME_ID); }

}  // namespace platon
