#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "levels/solve/solution.h"
#include "levels/solve/way_search.h"
#include "platon/game/game.h"
#include "platon/game/level.h"
#include "platon/physics/unfold.h"

namespace platon {

/// Approximate distance to a level's goal along the surface and around segments, for a small ball without gravity.
/// Computed on a grid over every face (Dijkstra's algorithm); a heuristic for searching, not an exact distance.
///
/// Hazards and closed doors block, and one-way segments from their left. Segments that block only one up do not. A key
/// that has not been taken is a goal too: what is left from there is the distance with all doors open.
class GoalDistance {
 public:
  static constexpr std::int32_t kUnreachable = INT32_MAX;

  /// `level` must outlive the object.
  explicit GoalDistance(const Level& level);

  /// Subunits from `place` to the goal; kUnreachable if segments enclose it. `open`: Game::openDoors. The first call
  /// with other open doors computes another grid.
  std::int32_t from(const Place& place, std::uint32_t open = 0);

 private:
  struct Cell {
    std::uint32_t face = 0;
    std::int32_t column = 0;
    std::int32_t row = 0;
  };
  struct Reached {
    std::int32_t distance = 0;
    Place place;  // centre of a cell, the goal, or a key
  };
  using Grid = std::vector<std::int32_t>;

  bool onGrid(const Cell& cell) const;
  std::size_t indexOf(const Cell& cell) const;
  Point centreOf(const Cell& cell) const;
  Cell cellAt(const Place& place) const;
  std::int32_t lookUp(const Grid& grid, const Cell& cell) const {
    return onGrid(cell) ? grid[indexOf(cell)] : kUnreachable;
  }

  const Grid& gridFor(std::uint32_t open);
  std::vector<Reached> sources(std::uint32_t open);
  Grid spread(std::uint32_t open, const std::vector<Reached>& sources) const;
  void spreadFrom(const Reached& reached, bool isSource, std::uint32_t open, Grid& grid,
                  std::vector<Reached>& front) const;
  std::int32_t distanceOn(const Grid& grid, const Place& place) const;

  const Level* level_;
  std::int32_t cellSize_;  // subunits
  std::int32_t side_;      // cells along each axis of a face; odd, so that the origin is the centre of a cell
  std::map<std::uint32_t, Grid> grids_;  // by open doors
};

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
