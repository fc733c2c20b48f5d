#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "client/demo/goal_distance.h"
#include "client/demo/planner.h"
#include "platon/game/game.h"

namespace platon {

/// Plays the game automatically: waits until the player rests, plans inputs that lead to the goal, and presses them. If
/// the game departs from the plan, it waits for rest and plans again; if there is no plan, it restarts the player. It
/// uses only the predicted game, like a human player.
class Demo {
 public:
  /// `effort`: maximum number of ticks simulated for planning per tick of the game.
  explicit Demo(std::uint32_t effort = 1500) : effort_(effort) {}

  /// Input for the next tick of `game`; empty while `slot` is absent or has finished. Another level or an earlier tick
  /// than in the last call starts a new round.
  Input choose(const Game& game, std::uint32_t slot);

 private:
  /// The part of the player's state that must match the plan.
  struct Motion {
    std::uint32_t part = 0;
    Point position;
    Point velocity;
    Angle up;

    friend bool operator==(const Motion&, const Motion&) = default;
  };

  static Motion motionOf(const Game& game, std::uint32_t slot);
  void startRound(const Game& game);
  Input waitForRest(const Game& game, std::uint32_t slot, const Motion& now);
  Input continuePlanning(const Game& game, std::uint32_t slot);
  void adoptPlan(const Game& start, std::uint32_t slot);
  Input restartPlayer();

  std::uint32_t effort_;
  std::shared_ptr<const Level> level_;
  std::uint32_t tick_ = 0;
  std::optional<GoalDistance> distance_;

  std::optional<Planner> planner_;  // while planning
  std::vector<Input> plan_;
  std::vector<Motion> expected_;  // before each tick of the plan
  std::size_t step_ = 0;          // next tick of the plan

  std::optional<Motion> last_;  // motion in the last call
  std::uint32_t restingTicks_ = 0;
  std::uint32_t waitedTicks_ = 0;
};

}  // namespace platon
