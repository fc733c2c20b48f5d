#include "client/quality/quality_meter.h"

#include <algorithm>

namespace platon {

void QualityMeter::add(double seconds) {
  if (!next_) return;
  spent_ += seconds;
  if (pictures_ > 0) times_.add(seconds);
  if (++pictures_ == kPictures) endLevel();
  if (spent_ < kMaxSeconds || !next_) return;
  next_.reset();
  if (fastest_ > kHoldSeconds) chosen_ = kQualities.front().level;
}

void QualityMeter::endLevel() {
  const QualityLevel level = *next_;
  const double seconds = times_.quantile(0.5);
  const bool holds = seconds <= kHoldSeconds;
  if (holds || seconds < fastest_) chosen_ = level;
  fastest_ = std::min(fastest_, seconds);
  pictures_ = 0;
  times_ = {};
  const bool rises = level >= kFirst;
  const QualityLevel last = holds ? kQualities.back().level : kQualities.front().level;
  next_.reset();
  if (holds && rises && level != last) next_ = static_cast<QualityLevel>(static_cast<int>(level) + 1);
  if (!holds && level <= kFirst && level != last) next_ = static_cast<QualityLevel>(static_cast<int>(level) - 1);
}

QualityLevel bestLevel(std::span<const double, kQualities.size()> seconds) {
  for (std::size_t i = seconds.size(); i-- > 0;) {
    if (seconds[i] <= QualityMeter::kHoldSeconds) return kQualities[i].level;
  }
  const auto fastest = std::min_element(seconds.begin(), seconds.end()) - seconds.begin();
  return kQualities[static_cast<std::size_t>(fastest)].level;
}

Quality QualityTrial::quality(const QualityChoice& choice) const {
  const bool measuring = !choice.level && skipped_ >= kSkipped && meter_.next();
  return measuring ? namedQuality(*meter_.next()).quality : choice.quality();
}

void QualityTrial::draw(QualityChoice& choice, const std::function<Time()>& now, const std::function<void()>& finish,
                        const std::function<void()>& draw) {
  if (choice.level) return draw();
  finish();
  const Time before = now();
  draw();
  finish();
  add(toSeconds(now() - before), choice);
}

void QualityTrial::add(double seconds, QualityChoice& choice) {
  if (skipped_ < kSkipped) {
    ++skipped_;
    return;
  }
  meter_.add(seconds);
  if (meter_.next()) return;
  choice.choose(meter_.chosen());
  *this = QualityTrial();
}

}  // namespace platon
