#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "client/demo/goal_distance.h"
#include "client/demo/planner.h"
#include "platon/game/game.h"

namespace platon {

/// Plays by itself: lets the player come to rest, plans a way to the goal from there and follows it. When the game
/// turns out otherwise than planned, it comes to rest and plans again; when there is no way left, it goes back to the
/// start. Knows no more than a player does: the predicted game.
class Demo {
 public:
  /// `effort`: ticks tried out at most for each tick of the game, which bounds the time that one takes.
  explicit Demo(std::uint32_t effort = 1500) : effort_(effort) {}

  /// The buttons for the next tick of `game`; nothing while `slot` is not in play. Another level or an earlier tick
  /// than before is a new round.
  Input choose(const Game& game, std::uint32_t slot);

 private:
  /// What tells whether a plan still holds.
  struct Motion {
    std::uint32_t part = 0;
    Point position;
    Point velocity;
    Angle up;

    friend bool operator==(const Motion&, const Motion&) = default;
  };

  static Motion motionOf(const Game& game, std::uint32_t slot);
  void startRound(const Game& game);
  Input rest(const Game& game, std::uint32_t slot, const Motion& now);
  Input think(const Game& game, std::uint32_t slot);
  void adopt(const Game& start, std::uint32_t slot);
  Input startOver();

  std::uint32_t effort_;
  std::shared_ptr<const Level> level_;
  std::uint32_t tick_ = 0;
  std::optional<GoalDistance> distance_;

  std::optional<Planner> planner_;  // while thinking, which is done at rest
  std::vector<Input> plan_;
  std::vector<Motion> expected_;  // at the start of every tick of the plan
  std::size_t step_ = 0;          // of the plan

  std::optional<Motion> before_;
  std::uint32_t restingTicks_ = 0;
  std::uint32_t waitedTicks_ = 0;
};

}  // namespace platon
