#include "client/audio/music_fade.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace platon {

void MusicFade::advance(std::optional<SolidKind> solid, double seconds) {
  const double step = seconds / kFadeSeconds;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const bool heard = solid && static_cast<std::size_t>(*solid) == i;
    parts_[i] = std::clamp(parts_[i] + (heard ? step : -step), 0.0, 1.0);
  }
  const double range = 1 - kDuckGain;
  duckGain_ += duckLeft_ > 0 ? -range * seconds / kAttackSeconds : range * seconds / kReleaseSeconds;
  duckGain_ = std::clamp(duckGain_, kDuckGain, 1.0);
  duckLeft_ = std::max(0.0, duckLeft_ - seconds);
}

double MusicFade::gain(SolidKind solid) const {
  return duckGain_ * std::sin(parts_[static_cast<std::size_t>(solid)] * std::numbers::pi / 2);
}

}  // namespace platon
