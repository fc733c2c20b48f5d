#pragma once

#include <chrono>
#include <cstdint>
#include <utility>

#include "platon/game/game.h"
#include "server/base/time_point.h"

namespace platon {

/// Tells when the ticks of a match are due: kTicksPerSecond a second, without drift.
class TickClock {
 public:
  /// Ticks that are made up for after a pause. When more are due, the others are dropped: the game has then been slower
  /// than the clock, but does not run through what nobody has seen.
  static constexpr std::uint64_t kMaxBehind = kTicksPerSecond / 4;

  explicit TickClock(TimePoint now) : start_(now) {}

  /// Time of the next tick.
  TimePoint next() const { return start_ + sinceStart(ticks_ + 1); }

  /// True when a tick is due at `now`; the clock then moves on to the one after it.
  bool take(TimePoint now) {
    if (now < next()) return false;
    const std::uint64_t behind = ticksUntil(now) - ticks_;
    if (behind > kMaxBehind) {
      dropped_ += behind - kMaxBehind;
      ticks_ += behind - kMaxBehind;
    }
    ++ticks_;
    return true;
  }

  /// Ticks dropped since the last call.
  std::uint64_t takeDropped() { return std::exchange(dropped_, 0); }

 private:
  static std::chrono::nanoseconds sinceStart(std::uint64_t ticks) {
    return std::chrono::nanoseconds(ticks * 1'000'000'000 / kTicksPerSecond);
  }
  // The largest number of ticks with sinceStart(ticks) <= now - start_.
  std::uint64_t ticksUntil(TimePoint now) const {
    const auto passed = static_cast<std::uint64_t>(std::chrono::nanoseconds(now - start_).count());
    return ((passed + 1) * kTicksPerSecond - 1) / 1'000'000'000;
  }

  TimePoint start_;
  std::uint64_t ticks_ = 0;  // dropped ones included
  std::uint64_t dropped_ = 0;
};

}  // namespace platon
