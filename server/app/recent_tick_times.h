#pragma once

#include <chrono>
#include <cstdint>

#include "server/app/tick_times.h"
#include "server/net/time_point.h"

namespace platon {

/// Durations of the ticks of the last minute, and of at most one more. Those of a server that nobody plays on any more
/// end with the time, not with the next ticks. Times never decrease.
class RecentTickTimes {
 public:
  static constexpr std::chrono::minutes kMinAge{1};

  void add(TimePoint now, std::chrono::nanoseconds time) {
    const std::int64_t minute = minuteOf(now);
    if (minute != minute_) previous_ = minute == minute_ + 1 ? current_ : TickTimes();
    if (minute != minute_) current_ = TickTimes();
    minute_ = minute;
    current_.add(time);
  }

  TickTimes all(TimePoint now) const {
    const std::int64_t passed = minuteOf(now) - minute_;
    TickTimes times;
    if (passed <= 1) times.add(current_);
    if (passed <= 0) times.add(previous_);
    return times;
  }

 private:
  static std::int64_t minuteOf(TimePoint now) { return now.time_since_epoch() / kMinAge; }

  std::int64_t minute_ = 0;  // of the last tick
  TickTimes current_;        // in this minute
  TickTimes previous_;       // in the minute before
};

}  // namespace platon
