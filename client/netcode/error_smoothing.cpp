#include "client/netcode/error_smoothing.h"

#include <algorithm>
#include <cstdint>

namespace platon {

Moment ErrorSmoothing::Correction::remaining(Moment now) const {
  return std::clamp(kDuration - (now - start), Moment::zero(), kDuration);
}

Point ErrorSmoothing::Correction::at(Moment now) const {
  const std::int64_t left = remaining(now).count();
  return {static_cast<std::int32_t>(offset.x * left / kDuration.count()),
          static_cast<std::int32_t>(offset.y * left / kDuration.count())};
}

void ErrorSmoothing::add(Point offset, Moment now) {
  while (count_ > 0 && corrections_.front().remaining(now) == Moment::zero()) dropOldest();
  if (count_ == kMaxCorrections) dropOldest();
  corrections_[count_++] = {offset, now};
}

void ErrorSmoothing::dropOldest() {
  std::move(corrections_.begin() + 1, corrections_.end(), corrections_.begin());
  --count_;
}

Point ErrorSmoothing::at(Moment now) const {
  Point sum;
  for (std::size_t i = 0; i < count_; ++i) sum += corrections_[i].at(now);
  return sum;
}

}  // namespace platon
