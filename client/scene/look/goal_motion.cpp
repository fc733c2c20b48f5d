#include "client/scene/look/goal_motion.h"

#include <algorithm>

namespace platon {

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
