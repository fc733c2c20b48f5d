#pragma once

#include <algorithm>
#include <chrono>

#include "protocol/time.h"

namespace platon {

/// A budget that refills at a constant rate up to a limit.
class TokenBucket {
 public:
  /// Starts full. `perSecond` and `limit` are in the unit of the budget, such as bytes.
  TokenBucket(double perSecond, double limit, Time now)
      : perSecond_(perSecond), limit_(limit), level_(limit), updated_(now) {}

  /// Takes `amount` from the budget. False, and nothing is taken, when less is left.
  bool take(double amount, Time now) {
    const double seconds = std::chrono::duration<double>(now - updated_).count();
    level_ = std::min(limit_, level_ + std::max(0.0, seconds) * perSecond_);
    updated_ = now;
    if (amount > level_) return false;
    level_ -= amount;
    return true;
  }

  /// Adds to the budget, up to its limit.
  void add(double amount) { level_ = std::min(limit_, level_ + amount); }

 private:
  double perSecond_;
  double limit_;
  double level_;
  Time updated_;
};

}  // namespace platon
