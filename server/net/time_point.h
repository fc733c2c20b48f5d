#pragma once

#include <chrono>

#include "protocol/moment.h"

namespace platon {

/// Monotonic time. Only main loops read the clock; everything else takes the time as an argument.
using TimePoint = std::chrono::steady_clock::time_point;

/// The same time for `protocol`.
inline Moment momentOf(TimePoint time) { return std::chrono::duration_cast<Moment>(time.time_since_epoch()); }

}  // namespace platon
