#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "levels/solve/solution.h"
#include "levels/solve/way_search.h"

namespace platon {

/// Searches for a way of all players of a level to its goal. One player takes the shortest way that WaySearch finds.
/// Several take turns: one moves to a key, a plate or the goal while the others stand still.
class LevelSolver {
 public:
  /// As of one search, but the states are those of all searches together.
  using Limits = WaySearch::Limits;

  explicit LevelSolver(std::shared_ptr<const Level> level) : level_(std::move(level)) {}

  std::optional<Solution> solve(const Limits& limits);
  std::optional<Solution> solve() { return solve(Limits()); }
  /// States that were searched.
  std::size_t states() const { return states_; }

 private:
  // All players stand still.
  struct Situation {
    Game game;
    Solution inputs;
    std::vector<std::uint32_t> places;  // what each player has gone to last, 0: the start
  };
  using Key = std::pair<std::vector<std::uint32_t>, std::uint32_t>;  // places, and doors that stay open

  std::optional<Solution> solveAlone(const Limits& limits);
  std::optional<Solution> solveTogether(const Limits& limits);
  Situation begin() const;
  void play(Situation& situation, std::uint32_t slot, const std::vector<Input>& inputs) const;
  bool settle(Situation& situation) const;
  std::uint32_t takenKeys(const Game& game) const;

  std::shared_ptr<const Level> level_;
  std::size_t states_ = 0;
};

}  // namespace platon
