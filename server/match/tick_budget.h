#pragma once

#include <chrono>
#include <cstdint>

#include "platon/game/game.h"
#include "protocol/token_bucket.h"

namespace platon {

/// A TokenBucket in ticks of the match: so much at once, and then more at a constant rate.
class TickBudget {
 public:
  TickBudget(double perSecond, double burst) : bucket_(perSecond, burst, Time(0)) {}

  /// Whether one more is within the budget at tick `now` of the match, which never decreases; it counts then.
  bool take(std::uint64_t now) { return bucket_.take(1, timeOf(now)); }

 private:
  static Time timeOf(std::uint64_t tick) { return std::chrono::microseconds(tick * 1'000'000 / kTicksPerSecond); }

  TokenBucket bucket_;
};

}  // namespace platon
