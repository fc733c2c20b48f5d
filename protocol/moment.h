#pragma once

#include <chrono>

namespace platon {

/// Monotonic time since an arbitrary origin. Nothing but the main loops reads a clock: callers pass the current moment,
/// so that tests can run in virtual time.
using Moment = std::chrono::microseconds;

constexpr double toSeconds(Moment moment) { return std::chrono::duration<double>(moment).count(); }

}  // namespace platon
