#pragma once

#include <chrono>

namespace platon {

/// Monotonic time since an arbitrary origin, or between two such times. Nothing but the main loops reads a clock:
/// callers pass the present time, so that tests can run in virtual time.
using Time = std::chrono::microseconds;

constexpr double toSeconds(Time time) { return std::chrono::duration<double>(time).count(); }

}  // namespace platon
