#pragma once

#include <functional>
#include <mutex>
#include <optional>

#include "protocol/moment.h"

namespace platon {

/// A monotonic clock that can be stopped and goes on from where it stood. Several threads may use it.
class PausableClock {
 public:
  /// `now` is the clock that it follows, which never decreases.
  explicit PausableClock(std::function<Moment()> now) : source_(std::move(now)) {}

  /// The time of the source less that of all pauses.
  Moment now() const;
  /// Stops or goes on. No effect if it does so already.
  void setPaused(bool paused);
  bool paused() const;

 private:
  std::function<Moment()> source_;
  mutable std::mutex mutex_;
  std::optional<Moment> stoppedAt_;  // what `now` returns during a pause
  Moment pauses_{};                  // of all pauses that have ended
};

}  // namespace platon
