#pragma once

#include <chrono>

#include "client/moment.h"

namespace platon {

/// The machine's monotonic clock; for the programs only.
inline Moment steadyNow() {
  return std::chrono::duration_cast<Moment>(std::chrono::steady_clock::now().time_since_epoch());
}

}  // namespace platon
