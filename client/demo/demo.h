#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "client/demo/goal_distance.h"
#include "levels/solve/solution.h"
#include "levels/solve/way_search.h"
#include "platon/game/game.h"

namespace platon {

/// Plays the game automatically. On a level with a recorded way, it restarts the player and presses the inputs of the
/// way; on another one, it waits until the player rests, searches for a way, and presses that. If the game departs from
/// the way, it begins again. It uses only the predicted game, like a human player.
class Demo {
 public:
  /// The recorded way of a level; nothing if there is none.
  using WayOf = std::function<std::optional<Solution>(const Level& level)>;

  /// `effort`: maximum number of ticks simulated for the search per tick of the game.
  explicit Demo(WayOf wayOf = {}, std::uint32_t effort = 1500) : wayOf_(std::move(wayOf)), effort_(effort) {}

  /// Input for the next tick of `game`; empty while `slot` is absent, or has finished a level for one. Another level or
  /// an earlier tick than in the last call starts a new round.
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
  bool isCommonStart(std::uint32_t tick) const;
  bool waitsInVain(const Game& game) const;
  Input beginWay(const Game& game, std::uint32_t slot);
  Input waitForRest(const Game& game, std::uint32_t slot);
  WaySearch::Limits limitsOfSearch(std::uint32_t slot);
  Input search(const Game& game, std::uint32_t slot);
  void adopt(const Game& start, std::uint32_t slot, const Solution& plan);
  Input restartPlayer();

  WayOf wayOf_;
  std::uint32_t effort_;
  std::shared_ptr<const Level> level_;
  std::uint32_t tick_ = 0;
  std::optional<Solution> way_;  // that is recorded of the level

  std::vector<Input> plan_;
  std::vector<Motion> expected_;  // before each tick of the plan
  std::size_t step_ = 0;          // next tick of the plan

  std::optional<Motion> last_;  // motion in the last call
  std::uint32_t restingTicks_ = 0;

  // Without a recorded way.
  std::optional<WaySearch> search_;
  std::shared_ptr<GoalDistance> distance_;  // of the level, once it was needed
  std::uint32_t waitedTicks_ = 0;
};

}  // namespace platon
