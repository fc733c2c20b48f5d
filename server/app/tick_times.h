#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>

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

}  // namespace platon
