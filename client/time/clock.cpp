#include "client/time/clock.h"

namespace platon {

Time PausableClock::now() const {
  const std::lock_guard lock(mutex_);
  return current();
}

Time PausableClock::current() const {
  if (paused_) return own0_;
  const Time passed = source_() - source0_;
  if (speed_ == 1) return own0_ + passed;
  return own0_ + Time(static_cast<Time::rep>(static_cast<double>(passed.count()) * speed_));
}

void PausableClock::setPaused(bool paused) {
  const std::lock_guard lock(mutex_);
  change(paused, speed_);
}

void PausableClock::setSpeed(double speed) {
  const std::lock_guard lock(mutex_);
  change(paused_, speed);
}

void PausableClock::change(bool paused, double speed) {
  if (paused == paused_ && speed == speed_) return;
  own0_ = current();
  source0_ = source_();
  paused_ = paused;
  speed_ = speed;
}

bool PausableClock::paused() const {
  const std::lock_guard lock(mutex_);
  return paused_;
}

}  // namespace platon
