#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace platon {

/// A time in which a player has reached the goal of a level.
struct BestTime {
  std::uint32_t ticks = 0;  ///< 1 … kMaxBestTicks
  std::string name;         ///< of the player, a label of 1 … kMaxNameBytes

  friend bool operator==(const BestTime&, const BestTime&) = default;
};

/// Keeps the best time of each level for a match, which has neither files nor a clock.
class BestTimeKeeper {
 public:
  virtual ~BestTimeKeeper() = default;
  /// The best time of the level with this hash; nothing if nobody has reached its goal.
  virtual std::optional<BestTime> best(std::uint64_t level) const = 0;
  /// A player has reached the goal of the level. Returns whether its time is less than the best one, which it replaces.
  /// `lasts`: otherwise the time ends with the server.
  virtual bool offer(std::uint64_t level, const BestTime& time, bool lasts) = 0;
};

}  // namespace platon
