#pragma once

#include <functional>

#include "protocol/moment.h"

namespace platon {

/// Monotonic clock, passed to every class that runs its own loop. Tests pass one that they control.
struct Clock {
  std::function<Moment()> now;             ///< never decreases
  std::function<void(Moment)> sleepUntil;  ///< returns at once if that moment has passed
};

}  // namespace platon
