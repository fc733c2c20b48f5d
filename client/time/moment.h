#pragma once

#include <chrono>

namespace platon {

/// Monotonic time since any one origin. Nothing in the client's library reads a clock: every caller says what time it
/// is, so that tests run in a time of their own.
using Moment = std::chrono::microseconds;

/// Seconds of it.
constexpr double toSeconds(Moment moment) { return std::chrono::duration<double>(moment).count(); }

}  // namespace platon
