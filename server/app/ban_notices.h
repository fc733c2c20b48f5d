#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <deque>

#include "server/net/time_point.h"

namespace platon {

/// Which refusals of banned addresses the log tells of: at most one in ten seconds, and one of each household in an
/// hour.
class BanNotices {
 public:
  static constexpr std::chrono::seconds kInterval{10};
  static constexpr std::chrono::hours kHouseholdInterval{1};

  /// A household (IpAddress::household) was refused. Whether to tell of it. `now` never decreases.
  bool take(std::uint64_t household, TimePoint now) {
    while (!told_.empty() && now - told_.front().at >= kHouseholdInterval) told_.pop_front();
    if (!told_.empty() && now - told_.back().at < kInterval) return false;
    if (std::any_of(told_.begin(), told_.end(), [&](const Notice& each) { return each.household == household; })) {
      return false;
    }
    told_.push_back({household, now});
    return true;
  }

  /// Households that it remembers: at most kHouseholdInterval / kInterval.
  std::size_t size() const { return told_.size(); }

 private:
  struct Notice {
    std::uint64_t household;
    TimePoint at;
  };

  std::deque<Notice> told_;  // oldest first
};

}  // namespace platon
