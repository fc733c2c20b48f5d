#include "client/quality/quality_trial.h"

namespace platon {

Quality QualityTrial::quality(const QualityChoice& choice) const {
  const bool measuring = !choice.level && skipped_ >= kSkipped && meter_.next();
  return measuring ? namedQuality(*meter_.next()).quality : choice.quality();
}

void QualityTrial::draw(QualityChoice& choice, const std::function<Moment()>& now, const std::function<void()>& finish,
                        const std::function<void()>& draw) {
  if (choice.level) return draw();
  finish();
  const Moment before = now();
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
