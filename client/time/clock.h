#pragma once

#include <functional>

#include "client/time/moment.h"

namespace platon {

/// The time as a program sees it: handed to whatever runs by itself.
struct Clock {
  std::function<Moment()> now;             ///< never decreases
  std::function<void(Moment)> sleepUntil;  ///< returns at once when that has passed
};

}  // namespace platon
