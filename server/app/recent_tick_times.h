#pragma once

#include <chrono>
#include <utility>

#include "platon/game/game.h"
#include "server/app/tick_times.h"

namespace platon {

/// Durations of the last ticks: at least kMinTicks of them if there were so many, and fewer than twice as many.
class RecentTickTimes {
 public:
  static constexpr std::uint64_t kMinTicks = 60 * kTicksPerSecond;

  void add(std::chrono::nanoseconds time) {
    if (current_.count() == kMinTicks) previous_ = std::exchange(current_, {});
    current_.add(time);
  }

  TickTimes all() const {
    TickTimes both = previous_;
    both.add(current_);
    return both;
  }

 private:
  TickTimes previous_;
  TickTimes current_;
};

}  // namespace platon
