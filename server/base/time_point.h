#pragma once

#include <chrono>

#include "protocol/time.h"

namespace platon {

/// Monotonic time. Only main loops read the clock; everything else takes the time as an argument.
using TimePoint = std::chrono::steady_clock::time_point;

/// The same time for `protocol`.
inline Time timeOf(TimePoint time) { return std::chrono::duration_cast<Time>(time.time_since_epoch()); }

}  // namespace platon
