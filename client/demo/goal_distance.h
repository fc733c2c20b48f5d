#pragma once

#include <cstdint>
#include <vector>

#include "platon/game/level.h"
#include "platon/physics/unfold.h"

namespace platon {

/// Approximate distance to a level's goal along the surface and around segments, for a small ball without gravity.
/// Computed once on a grid over every face (Dijkstra's algorithm); a heuristic for searching, not an exact distance.
class GoalDistance {
 public:
  static constexpr std::int32_t kUnreachable = INT32_MAX;

  explicit GoalDistance(const Level& level);

  /// Subunits from `place` to the goal; kUnreachable if segments enclose it.
  std::int32_t from(const Place& place) const;

 private:
  struct Cell {
    std::uint32_t face = 0;
    std::int32_t column = 0;
    std::int32_t row = 0;
  };
  struct Reached {
    std::int32_t distance = 0;
    Place place;  // centre of a cell, or the goal
  };

  bool onGrid(const Cell& cell) const;
  std::size_t indexOf(const Cell& cell) const;
  Point centreOf(const Cell& cell) const;
  Cell cellAt(const Place& place) const;
  std::int32_t lookUp(const Cell& cell) const { return onGrid(cell) ? distances_[indexOf(cell)] : kUnreachable; }

  void spread(const Geometry& geometry, const Place& goal);
  void spreadFrom(const Geometry& geometry, const Reached& reached, std::vector<Reached>& front);

  std::int32_t cellSize_;  // subunits
  std::int32_t side_;      // cells along each axis of a face; odd, so that the origin is the centre of a cell
  std::vector<std::int32_t> distances_;
};

}  // namespace platon
