#include "client/time/pausable_clock.h"

namespace platon {

Moment PausableClock::now() const {
  const std::lock_guard lock(mutex_);
  return stoppedAt_ ? *stoppedAt_ : source_() - pauses_;
}

void PausableClock::setPaused(bool paused) {
  const std::lock_guard lock(mutex_);
  if (paused == stoppedAt_.has_value()) return;
  const Moment now = source_() - pauses_;
  if (paused) {
    stoppedAt_ = now;
  } else {
    pauses_ += now - *stoppedAt_;
    stoppedAt_.reset();
  }
}

bool PausableClock::paused() const {
  const std::lock_guard lock(mutex_);
  return stoppedAt_.has_value();
}

}  // namespace platon
