#include "client/scene/stage_motion.h"

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

void GoalMotion::advance(bool arrived, double seconds) {
  const bool began = seconds < seconds_;
  if (arrived && (!arrived_ || began)) since_ = seconds;
  // A player that had arrived before this was drawn is not celebrated again.
  if (arrived && (began || seconds_ == 0)) since_ = seconds - kBurst;
  arrived_ = arrived;
  seconds_ = seconds;
  const double passed = seconds - since_;
  opened_ = arrived ? std::clamp(passed / kOpening, 0.0, 1.0) : 0;
  burst_ = arrived ? std::clamp(passed / kBurst, 0.0, 1.0) : 1;
}

void GoalMotion::settle() {
  opened_ = arrived_ ? 1 : 0;
  burst_ = 1;
}

}  // namespace platon
