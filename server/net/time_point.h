#pragma once

#include <chrono>

namespace platon {

/// Monotonic time. Only main loops read the clock; everything else is told what time it is.
using TimePoint = std::chrono::steady_clock::time_point;

}  // namespace platon
