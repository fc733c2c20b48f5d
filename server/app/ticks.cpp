#include "server/app/ticks.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace platon {

// Durations with the same number of bits share 16 buckets, so that a bucket spans at most a sixteenth of its durations.
std::size_t TickTimes::bucketOf(std::uint64_t microseconds) {
  constexpr std::uint64_t kMaxMicroseconds = (std::uint64_t{1} << kLongestBits) - 1;
  const std::uint64_t time = std::min(microseconds, kMaxMicroseconds);
  const auto length = static_cast<unsigned>(std::bit_width(time));
  const unsigned dropped = length > kBits + 1 ? length - kBits - 1 : 0;
  return (std::size_t{dropped} << kBits) + static_cast<std::size_t>(time >> dropped);
}

std::uint64_t TickTimes::longestIn(std::size_t bucket) {
  constexpr std::size_t kFirst = std::size_t{1} << kBits;
  const std::size_t dropped = bucket < 2 * kFirst ? 0 : (bucket >> kBits) - 1;
  const std::uint64_t kept = bucket - (dropped << kBits);
  return ((kept + 1) << dropped) - 1;
}

void TickTimes::add(std::chrono::nanoseconds time) {
  const auto microseconds = static_cast<std::uint64_t>(std::max<std::int64_t>(time / std::chrono::microseconds(1), 0));
  ++ticks_[bucketOf(microseconds)];
  ++count_;
  longest_ = std::max(longest_, microseconds);
  sum_ += microseconds;
}

void TickTimes::add(const TickTimes& other) {
  for (std::size_t bucket = 0; bucket < kBuckets; ++bucket) ticks_[bucket] += other.ticks_[bucket];
  count_ += other.count_;
  longest_ = std::max(longest_, other.longest_);
  sum_ += other.sum_;
}

std::uint64_t TickTimes::quantile(double share) const {
  const auto rank = static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(count_)));
  std::uint64_t seen = 0;
  for (std::size_t bucket = 0; bucket < kBuckets; ++bucket) {
    seen += ticks_[bucket];
    if (seen > 0 && seen >= rank) return std::min(longestIn(bucket), longest_);
  }
  return 0;
}

}  // namespace platon
