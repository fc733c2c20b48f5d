#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "server/base/time_point.h"

namespace platon {

/// Histogram of the durations of ticks, of constant size. Durations are exact below 32 µs, rounded up by at most a
/// sixteenth above, and cut off at 1 s. The longest one is always exact to the microsecond.
class TickTimes {
 public:
  /// Adds the duration of a tick, rounded down to microseconds.
  void add(std::chrono::nanoseconds time);
  /// Adds all durations of another histogram.
  void add(const TickTimes& other);

  std::uint64_t count() const { return count_; }
  /// Duration that `share` (0 … 1) of the ticks did not exceed, microseconds; 0 without ticks.
  std::uint64_t quantile(double share) const;
  /// Longest duration, microseconds.
  std::uint64_t longest() const { return longest_; }
  /// Sum of all durations, each rounded down to microseconds.
  std::uint64_t sum() const { return sum_; }

 private:
  static constexpr unsigned kBits = 4;          // significant bits of a duration after the first
  static constexpr unsigned kLongestBits = 20;  // bits of the longest duration, microseconds
  static constexpr std::size_t kBuckets = std::size_t{kLongestBits - kBits + 1} << kBits;

  static std::size_t bucketOf(std::uint64_t microseconds);
  static std::uint64_t longestIn(std::size_t bucket);

  std::array<std::uint64_t, kBuckets> ticks_{};  // number of ticks by bucket
  std::uint64_t count_ = 0;
  std::uint64_t longest_ = 0;
  std::uint64_t sum_ = 0;
};

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
