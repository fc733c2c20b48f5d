#pragma once

#include <functional>
#include <mutex>

#include "protocol/time.h"

namespace platon {

/// Monotonic clock, passed to every class that runs its own loop. Tests pass one that they control.
struct Clock {
  std::function<Time()> now;             ///< never decreases
  std::function<void(Time)> sleepUntil;  ///< returns at once if that moment has passed
};

/// A monotonic clock that can be stopped, goes on from where it stood, and can run slower. Several threads may use it.
class PausableClock {
 public:
  /// `now` is the clock that it follows, which never decreases.
  explicit PausableClock(std::function<Time()> now) : source_(std::move(now)), source0_(source_()), own0_(source0_) {}

  /// The time of the source less that of all pauses, at the speeds at which it passed.
  Time now() const;
  /// Stops or goes on. No effect if it does so already.
  void setPaused(bool paused);
  bool paused() const;
  /// From now on a second of the source is so many seconds of this clock, more than 0 and at most 1; at first 1.
  void setSpeed(double speed);

 private:
  Time current() const;
  void change(bool paused, double speed);

  std::function<Time()> source_;
  mutable std::mutex mutex_;
  Time source0_;  // time of the source at the last change
  Time own0_;     // time of this clock then
  double speed_ = 1;
  bool paused_ = false;
};

}  // namespace platon
