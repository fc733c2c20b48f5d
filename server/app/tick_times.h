#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>

namespace platon {

/// How long ticks took, in a fixed amount of memory: exact below 32 µs, above to a sixteenth, beyond 1 s as 1 s. Only
/// the longest is always exact to the microsecond.
class TickTimes {
 public:
  /// A tick took so long; parts of a microsecond do not count.
  void add(std::chrono::nanoseconds time);

  std::uint64_t count() const { return count_; }
  /// Microseconds that `share` (0 … 1) of the ticks did not exceed, rounded up to a sixteenth; 0 without any.
  std::uint64_t quantile(double share) const;
  /// Microseconds.
  std::uint64_t longest() const { return longest_; }

 private:
  static constexpr unsigned kBits = 4;          // of a time that count
  static constexpr unsigned kLongestBits = 20;  // of a time in microseconds
  static constexpr std::size_t kBuckets = std::size_t{kLongestBits - kBits + 1} << kBits;

  static std::size_t bucketOf(std::uint64_t microseconds);
  static std::uint64_t longestIn(std::size_t bucket);

  std::array<std::uint64_t, kBuckets> ticks_{};  // by bucket
  std::uint64_t count_ = 0;
  std::uint64_t longest_ = 0;
};

}  // namespace platon
