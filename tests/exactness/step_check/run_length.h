#pragma once

#include <cstdint>
#include <cstdlib>

namespace platon::step_check {

/// Number of repetitions of a hard or a lockstep test: `usual`, or `full` if the environment variable PLATON_LONG is
/// set, as it is in builds with the CMake option of that name.
inline std::int64_t runLength(std::int64_t usual, std::int64_t full) {
  return std::getenv("PLATON_LONG") != nullptr ? full : usual;
}

}  // namespace platon::step_check
