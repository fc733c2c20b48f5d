#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "server/match/round_times.h"

namespace platon {

/// Best times in memory.
class KeptTimes : public BestTimeKeeper {
 public:
  std::optional<BestTime> best(std::uint64_t level) const override {
    const auto found = times_.find(level);
    return found == times_.end() ? std::nullopt : std::optional(found->second);
  }
  bool offer(std::uint64_t level, const BestTime& time, bool lasts) override {
    offered.push_back(time);
    if (lasts) lasting.push_back(time);
    const auto [place, isNew] = times_.try_emplace(level, time);
    if (!isNew && place->second.ticks <= time.ticks) return false;
    place->second = time;
    return true;
  }

  std::vector<BestTime> offered;
  std::vector<BestTime> lasting;  // of these

 private:
  std::map<std::uint64_t, BestTime> times_;
};

}  // namespace platon
