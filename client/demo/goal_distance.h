#pragma once

#include <cstdint>
#include <map>
#include <vector>

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

}  // namespace platon
