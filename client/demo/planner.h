#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_set>
#include <vector>

#include "client/demo/goal_distance.h"
#include "platon/game/game.h"

namespace platon {

/// Searches for buttons that bring a player to the goal, by trying them out on a copy of the game. Weighted best-first:
/// time taken plus the way that is left round the walls. Works in portions, so that a picture can be drawn in between;
/// the result depends on nothing but the game.
class Planner {
 public:
  enum class Status { kSearching, kFound, kNoWay };

  /// Plans for `slot` from `start` on, as if nobody else was there. `distance` is of the same level and outlives this.
  Planner(const Game& start, std::uint32_t slot, const GoalDistance& distance);

  /// Tries out about this many ticks more.
  Status work(std::uint32_t ticks);
  Status status() const { return status_; }

  /// Once found: the buttons for every tick from the start to the one that touches the goal, with kPresent.
  const std::vector<Input>& plan() const { return plan_; }

 private:
  struct Node {
    std::uint32_t parent = 0;
    std::uint32_t depth = 0;          // strides from the start
    std::uint8_t buttons = 0;         // held for a stride to come here from the parent
    std::vector<std::uint8_t> state;  // of the game; empty once expanded
  };
  struct Candidate {
    std::int64_t cost = 0;
    std::uint32_t node = 0;
    bool operator<(const Candidate& other) const { return cost != other.cost ? cost > other.cost : node > other.node; }
  };

  void expand(std::uint32_t index);
  /// Holds the buttons for a stride; the ticks until the goal was touched, or 0.
  std::uint32_t tryOut(std::uint8_t buttons);
  void keep(std::uint32_t parent, std::uint8_t buttons);
  void finish(std::uint32_t index, std::uint8_t buttons, std::uint32_t ticks);
  std::uint64_t signature() const;
  std::int64_t cost(std::uint32_t depth) const;

  const GoalDistance* distance_;
  Game game_;  // what is tried out on
  std::uint32_t slot_;
  std::vector<Input> inputs_;
  Status status_ = Status::kSearching;
  std::vector<Node> nodes_;
  std::vector<Candidate> open_;  // a heap, the cheapest first
  std::unordered_set<std::uint64_t> seen_;
  std::vector<Input> plan_;
};

}  // namespace platon
