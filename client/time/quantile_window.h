#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace platon {

/// Quantiles of the last `kSize` samples.
template <std::size_t kSize>
class QuantileWindow {
 public:
  void add(double sample) {
    samples_[next_] = sample;
    next_ = (next_ + 1) % kSize;
    count_ = std::min(count_ + 1, kSize);
  }

  bool empty() const { return count_ == 0; }

  /// The smallest sample that is at least as large as `share` (0 … 1) of all samples; 0 gives the minimum. The window
  /// must not be empty.
  double quantile(double share) const {
    std::array<double, kSize> sorted = samples_;
    const double rank = std::max(1.0, std::ceil(share * static_cast<double>(count_)));
    const auto found = sorted.begin() + static_cast<std::ptrdiff_t>(rank) - 1;
    std::nth_element(sorted.begin(), found, sorted.begin() + static_cast<std::ptrdiff_t>(count_));
    return *found;
  }

 private:
  std::array<double, kSize> samples_{};  // ring buffer; the first count_ are valid
  std::size_t next_ = 0;
  std::size_t count_ = 0;
};

}  // namespace platon
