#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "platon/game/game.h"
#include "platon/game/input.h"

namespace platon {

/// Where a player lies who presses nothing: what it goes through from the start of the level, until it rests.
class LevelRest {
 public:
  /// Most ticks that are looked at. On usual levels a player rests after some tens.
  static constexpr std::uint32_t kMaxTicks = 600;

  /// Plays up to kMaxTicks ticks of one player. On a level with timed segments that such a player can meet there is no
  /// rest: `ticksTo` returns nothing.
  explicit LevelRest(const std::shared_ptr<const Level>& level);

  /// The ticks without a button after which a player is as that of `slot` is: the same place and motion, and no
  /// attempt. Nothing if there are none, or if the slot has no player. What it holds, and what it has finished before,
  /// makes no difference.
  std::optional<std::uint32_t> ticksTo(const Game& game, std::uint32_t slot) const;
  /// Whether the players of `game` who are as in `ticksTo` have taken all keys that are taken, and press all plates
  /// that are pressed. A key opens its doors for good, a plate for a tick, so neither stands for the other.
  bool explainsDoorsOf(const Game& game) const;

 private:
  // A player in a game.
  struct Stay {
    EntityState entity;
    std::vector<InstanceState> instances;
    PlayerState player;

    friend bool operator==(const Stay&, const Stay&) = default;
  };

  // Bits as Game::takenKeys and Game::pressedPlates have them.
  struct Opened {
    std::uint32_t keys = 0;
    std::uint32_t plates = 0;
  };

  void play(const std::shared_ptr<const Level>& level);
  static Stay stayOf(const Game& game, std::uint32_t slot);

  std::vector<Stay> stays_;     // after 1, 2 … ticks
  std::vector<Opened> opened_;  // by such a player, as stays_
};

/// The end of a run.
struct RunFinish {
  std::uint32_t slot = 0;
  std::uint32_t ticks = 0;  ///< time of the attempt
};

/// Decides whether a recording shows a run: an attempt that begins at the start of the level, at rest, with its clock
/// at 0, and ends at the goal in the last tick. A recording may begin in any state, which whoever makes it can invent;
/// so a player who is there at its beginning, and whom the game has not put back to the start since, must lie where
/// one lies who has pressed nothing. Where there are doors, that holds for all players, also for those who are put back
/// in the first tick of the attempt, and only keys and plates that such players touch may be in use.
class RecordedRun {
 public:
  /// `start`: the game before the first recorded tick.
  explicit RecordedRun(const Game& start);

  /// The inputs of the next recorded tick, by slot.
  void add(std::span<const Input> inputs);

  /// The run, or why there is none, as the end of a sentence that begins with the name of the recording. `end`: the
  /// game after the last tick, of which all inputs have been added; `before`: the one before that tick.
  std::variant<RunFinish, std::string> finish(const Game& before, const Game& end) const;

 private:
  // A player who is there at the beginning.
  struct Found {
    std::uint8_t held = 0;
    std::uint32_t renewedAt =
        UINT32_MAX;  // tick in which it first leaves or restarts; counted as PlayerState::startedAt
  };

  std::string faultOf(std::uint32_t slot, std::uint32_t startedAt) const;
  bool isThere(std::uint32_t slot, std::uint32_t startedAt) const;

  Game start_;
  std::uint32_t tick_;  // of the game after what was added
  std::vector<Found> found_;
};

}  // namespace platon
