#pragma once

#include <chrono>

namespace platon {

/// Monotonic time. Only main loops read the clock; everything else takes the time as an argument.
using TimePoint = std::chrono::steady_clock::time_point;

}  // namespace platon
