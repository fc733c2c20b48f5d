#pragma once

#include <cstdint>
#include <cstdlib>

#include "tests/support/run/repetitions.h"

namespace platon::step_check {

/// Whether hard and lockstep tests run at full length: the environment variable PLATON_LONG is set, as it is in builds
/// with the CMake option of that name.
inline bool isLong() { return std::getenv("PLATON_LONG") != nullptr; }

/// Number of repetitions of a hard or a lockstep test: `full` in a long run, else repetitions(usual).
inline std::int64_t runLength(std::int64_t usual, std::int64_t full) { return isLong() ? full : repetitions(usual); }

/// Distance of the cases that are tried of many: 1 in a long run, else `usual`.
inline std::int64_t stride(std::int64_t usual) { return isLong() ? 1 : usual; }

}  // namespace platon::step_check
