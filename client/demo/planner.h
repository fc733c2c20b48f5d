#pragma once

#include <cstdint>
#include <unordered_set>
#include <vector>

#include "client/demo/goal_distance.h"
#include "platon/game/game.h"

namespace platon {

/// Searches for inputs that bring a player to the goal, by simulating a copy of the game. A best-first search weighted
/// by time taken plus remaining goal distance. It works in steps, so that frames can be drawn in between; the result
/// depends only on the game.
class Planner {
 public:
  enum class Status { kSearching, kFound, kNoPlan };

  /// Plans for `slot` from the state `start`, without input from other players. `distance`: of the same level; must
  /// outlive the planner.
  Planner(const Game& start, std::uint32_t slot, GoalDistance& distance);

  /// Simulates about this many further ticks.
  Status work(std::uint32_t ticks);
  Status status() const { return status_; }

  /// Once found: the inputs of every tick up to the one that reaches the goal, with kPresent.
  const std::vector<Input>& plan() const { return plan_; }

 private:
  struct Node {
    std::uint32_t parent = 0;
    std::uint32_t depth = 0;          // strides from the start
    std::uint8_t buttons = 0;         // held for a stride from the parent to this node
    std::vector<std::uint8_t> state;  // saved game; empty once expanded
  };
  struct Candidate {
    std::int64_t cost = 0;
    std::uint32_t node = 0;
    bool operator<(const Candidate& other) const { return cost != other.cost ? cost > other.cost : node > other.node; }
  };

  void expand(std::uint32_t index);
  /// Simulates a stride with these buttons held. Returns the ticks until the goal was reached, or 0.
  std::uint32_t simulate(std::uint8_t buttons);
  void keep(std::uint32_t parent, std::uint8_t buttons);
  void finish(std::uint32_t index, std::uint8_t buttons, std::uint32_t ticks);
  std::uint64_t signature() const;
  std::int64_t cost(std::uint32_t depth) const;

  GoalDistance* distance_;
  Game game_;  // scratch for simulation
  std::uint32_t slot_;
  std::vector<Input> inputs_;
  Status status_ = Status::kSearching;
  std::vector<Node> nodes_;
  std::vector<Candidate> open_;  // heap with the cheapest on top
  std::unordered_set<std::uint64_t> seen_;
  std::vector<Input> plan_;
};

}  // namespace platon
