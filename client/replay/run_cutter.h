#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "platon/game/game.h"
#include "platon/game/level.h"
#include "platon/game/recorded_run.h"

namespace platon {

/// One attempt of a player from its first input to the goal.
struct Run {
  std::shared_ptr<const Level> level;
  std::uint32_t ticks = 0;              ///< its time, as the game counts it
  std::vector<std::uint8_t> recording;  ///< ends with the tick in which the player touches the goal
};

/// Cuts the local player's attempts out of the rounds, each as a recording of its own. Usually that is a game of this
/// player alone, from the start of the level. Where other players helped, it is the game of all players, from before
/// the first input that the time of the attempt counts from.
class RunCutter {
 public:
  /// Ticks between the checkpoints of a run's recording.
  static constexpr std::uint32_t kCheckpointTicks = 600;
  /// Longest attempt of one player that is recorded, with the rest before it: 30 min. Its inputs and its recording are
  /// bounded by that, and so is the time to play it once.
  static constexpr std::size_t kMaxTicks = 30 * 60 * kTicksPerSecond;

  /// Goes on with another game, whose past is not known.
  void begin(const Game& game, std::uint32_t slot);
  /// `game` has been advanced by `inputs`. Returns the time of the attempt if it has reached the goal in this tick.
  std::optional<std::uint32_t> advance(std::span<const Input> inputs, const Game& game);
  /// The run that has ended with the tick of the last call of `advance`, after which `game` is. Nothing if it began
  /// before the game was known, or if it costs too much to be played again (PlayCost). Plays the run once.
  std::optional<Run> cut(const Game& game) const;
  /// Whether the attempt can be cut out of the group's game but for the cost of its recording.
  bool isGroupTooCostly() const { return isInGroup() && !isGroupAffordable(); }

 private:
  static constexpr std::size_t kMaxGroupTicks = 2 * kRoundTicks;  // as kMaxTicks, of several players
  static constexpr std::size_t kMinGroupTicks = 60;  // the start of the group's game is set at most so often

  // The local player after a tick.
  struct Own {
    EntityState entity;
    PlayerState player;

    friend bool operator==(const Own&, const Own&) = default;
  };

  std::optional<Own> ownIn(const Game& game) const;
  void followOwn(Input input, const Own& own);
  void followGroup(std::span<const Input> inputs, const Game& game);
  bool allRest(const Game& game) const;
  bool isInGroup() const;
  bool isGroupAffordable() const;
  std::optional<Run> cutAlone(const Game& game) const;
  std::optional<Run> cutGroup(const Game& game) const;

  std::uint32_t slot_ = 0;
  std::optional<Own> own_;                       // after the last tick; nothing: the player is absent
  bool known_ = false;                           // inputs_ leads from a new game to own_
  std::vector<Input> inputs_;                    // of the local player in a game of its own
  std::optional<LevelRest> rest_;                // on a level with doors or timed segments, or if own_ has not started
                                                 // in `begin`
  std::optional<Game> start_;                    // of the group's game, on a level with doors or timed segments
  std::vector<std::vector<Input>> groupInputs_;  // since start_
};

}  // namespace platon
