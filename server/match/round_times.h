#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "protocol/to_client.h"

namespace platon {

class Game;
struct Level;
class PlayerNames;

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

/// Notes the times in which players reach the goal in a round, and offers those that count to the keeper of the best
/// times. An attempt in which times did not count gives none. Where the times of one player are kept, those of others,
/// and of attempts in which more players were connected than the level needs, end with the server.
class RoundTimes {
 public:
  /// `keeper` must outlive this; null: there are no best times. `keepsTimesOfOne`: as in MatchSettings.
  RoundTimes(BestTimeKeeper* keeper, bool keepsTimesOfOne) : keeper_(keeper), keepsTimesOfOne_(keepsTimesOfOne) {}

  void startRound();
  /// Whether times count from now on; they do at first.
  void count(bool counts) { counts_ = counts; }
  /// The slots of the players of the one client whose times are kept if those of one are; nobody's at first.
  void keepOf(const SlotsByLocal& slots) { kept_ = slots; }
  /// Call after each tick of the game. `players`: number of connected ones. Returns whether a player has reached the
  /// goal in the best time of the level.
  bool note(const Game& game, const PlayerNames& names, std::size_t players);
  /// The best time of the level, and whether it was reached in this round.
  std::optional<LevelBest> best(const Level& level) const;

 private:
  void noteAttempts(const Game& game, std::size_t players);
  bool offerFinishes(const Game& game, const PlayerNames& names);
  bool arrives(const Game& game, std::uint32_t slot) const;

  BestTimeKeeper* keeper_;
  bool keepsTimesOfOne_;
  SlotsByLocal kept_;
  bool counts_ = true;
  std::uint32_t uncountedAt_ = 0;  // last tick of the round in which times did not count; 0: none
  std::uint32_t sharedAt_ = 0;     // last tick of the round with more players than the level needs; 0: none
  std::vector<bool> arrived_;      // by slot: at the goal in the tick before the last one
  bool bestIsNew_ = false;         // the best time of the level was reached in this round
};

}  // namespace platon
