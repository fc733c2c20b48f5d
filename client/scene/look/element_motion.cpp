#include "client/scene/look/element_motion.h"

#include <algorithm>
#include <cstddef>

#include <glm/common.hpp>

namespace platon {

void ElementMotion::advance(const std::vector<std::uint8_t>& active, double seconds) {
  const double step = (seconds - seconds_) / kSeconds;
  const bool anew = active.size() != active_.size() || step < 0 || (step == 0 && active != active_);
  seconds_ = seconds;
  active_ = active;
  if (anew) return settle();
  for (std::size_t i = 0; i < active.size(); ++i) {
    progress_[i] += std::clamp(active[i] - progress_[i], -step, step);
    shares_[i] = glm::smoothstep(0.0, 1.0, progress_[i]);
  }
}

void ElementMotion::settle() {
  progress_.assign(active_.begin(), active_.end());
  shares_ = progress_;
}

}  // namespace platon
