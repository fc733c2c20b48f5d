#pragma once

#include <cstdint>
#include <map>

namespace platon {

/// Lets a cue pass once when reconciliation shows its event again. An event that is predicted anew comes a few ticks
/// earlier or later than before, so a repetition within a short time is taken for the same event.
class ReplayFilter {
 public:
  /// Whether the event `key` of tick `tick` is a new one: none with this key has passed in the `ticks` ticks before.
  bool passes(std::uint32_t key, std::uint32_t tick, std::uint32_t ticks) {
    const auto [found, isFirst] = last_.try_emplace(key, tick);
    if (!isFirst && tick < found->second + ticks) return false;
    found->second = tick;
    return true;
  }

 private:
  std::map<std::uint32_t, std::uint32_t> last_;  // tick of the last event that has passed, by key
};

}  // namespace platon
