#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "platon/game/game.h"

namespace platon {

/// The inputs of all players, by tick, then by slot, from the start of a round to the tick in which the last player
/// touches the goal.
using Solution = std::vector<std::vector<Input>>;

/// What a solution asks of its players.
struct SolutionFacts {
  std::uint32_t ticks = 0;           ///< from the first input to the goal
  std::uint32_t presses = 0;         ///< of the buttons left, right, jump and down, by all players
  std::uint32_t crossings = 0;       ///< of edges; for several players those of the one with the fewest
  std::uint32_t turns = 0;           ///< returns to a face with another up, by all players
  std::optional<int> slack;          ///< ticks for which the tightest jump may be pressed; nothing without a jump
  std::set<std::uint32_t> elements;  ///< indices of the keys, plates and checkpoints that were touched

  friend bool operator==(const SolutionFacts&, const SolutionFacts&) = default;
};

/// How hard a solution is, to put levels in order: each press counts 1, each turn of down 4, and each tick that a
/// player has less than 12 for the tightest jump counts 1.
int difficultyOf(const SolutionFacts& facts);

/// Replays a solution. Nothing when it does not bring all players to the goal in its last tick.
std::optional<SolutionFacts> factsOf(const std::shared_ptr<const Level>& level, const Solution& solution);

/// For how many ticks the tightest jump of a solution may be pressed: the player runs on or waits as before the jump,
/// jumps some ticks earlier or later, holds the same buttons as in the solution, and comes to stand where it did there.
/// At most 2 * kMaxJumpSlack + 1. Nothing when no player jumps.
std::optional<int> tightestJump(const std::shared_ptr<const Level>& level, const Solution& solution);

/// Most ticks by which a jump is tried earlier and later.
inline constexpr int kMaxJumpSlack = 15;

}  // namespace platon
