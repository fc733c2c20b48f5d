#pragma once

#include <chrono>
#include <ctime>

#include "protocol/moment.h"

namespace platon {

/// Time for which a processor has worked for the calling thread. Only programs and tests may use it.
inline Moment threadTime() {
  std::timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return std::chrono::duration_cast<Moment>(std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec));
}

}  // namespace platon
