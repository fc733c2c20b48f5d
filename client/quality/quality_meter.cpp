#include "client/quality/quality_meter.h"

namespace platon {

void QualityMeter::add(double seconds) {
  if (!next_) return;
  spent_ += seconds;
  if (pictures_ > 0) times_.add(seconds);
  if (++pictures_ == kPictures) endLevel();
  if (spent_ >= kMaxSeconds) next_.reset();
}

void QualityMeter::endLevel() {
  const bool holds = times_.quantile(0.5) <= kHoldSeconds;
  if (holds) chosen_ = *next_;
  const bool last = *next_ == kQualities.back().level;
  pictures_ = 0;
  times_ = {};
  if (holds && !last)
    next_ = static_cast<QualityLevel>(static_cast<int>(*next_) + 1);
  else
    next_.reset();
}

QualityLevel bestLevel(std::span<const double> seconds) {
  QualityLevel best = kQualities.front().level;
  for (const NamedQuality& named : kQualities) {
    const auto index = static_cast<std::size_t>(named.level);
    if (index >= seconds.size() || !(seconds[index] <= QualityMeter::kHoldSeconds)) break;
    best = named.level;
  }
  return best;
}

}  // namespace platon
