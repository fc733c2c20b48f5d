#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "levels/reach/reach_walls.h"
#include "platon/game/player.h"

namespace platon {

/// Least distance of the edges of the player's shape from its middle, in level units.
inline constexpr double kApothemInUnits = double{1} * kPlayerApothem / kSubunitsPerUnit;

/// A one-way segment within reach of a face. Where it goes straight on in another one or in a wall, for instance over
/// an edge, its line is longer than it is, so that no cell goes between them.
struct ReachOneway {
  Line line;
  std::vector<Line> floors;  ///< walls in the same straight line that it touches
};

/// An upright face divided into square cells: where the centre of a player can be, and what it can touch there. Every
/// answer errs on the side of the player: what is impossible here is impossible in the game.
class ReachGrid {
 public:
  /// A cell in which the centre of a player can be, as far as one can tell.
  struct Cell {
    bool inside = false;      ///< overlaps the face
    bool blocked = false;     ///< wherever the centre is in the cell, a wall overlaps the player
    bool grounded = false;    ///< the player may stand
    bool sloped = false;      ///< on a slope or on an end, which may give an upward speed
    bool slowed = false;      ///< a segment below the player may push it sideways or slow its fall
    bool steep = false;       ///< which is steep
    bool nearOneway = false;  ///< a one-way segment is within reach
    bool atGoal = false;      ///< the player may touch the goal
    std::uint32_t doors = 0;  ///< bits of the doors that block the cell
    double flattest = 1e300;  ///< tangent of the flattest steep segment below the player
    double highest = -1e300;  ///< y of the highest centre at which the player may stand
  };

  ReachGrid(const Level& level, const UprightFaces& faces, std::uint32_t node, double cellSize);

  std::int32_t columns() const { return columns_; }
  std::size_t size() const { return cells_.size(); }
  const Cell& operator[](std::size_t cell) const { return cells_[cell]; }
  Rect rectOf(std::size_t cell) const;
  /// The cell with this point; size() outside of the grid.
  std::size_t cellAt(Vec point) const;
  /// All cells that a rectangle overlaps.
  void findOverlapped(const Rect& rect, std::vector<std::size_t>& found) const;
  /// The checkpoints and what opens doors that a player in the cell may touch.
  std::span<const ReachWall> touched(std::size_t cell) const;
  const std::vector<ReachOneway>& oneways() const { return oneways_; }

 private:
  template <class Visitor>
  void visitNear(const Line& line, double reach, Visitor&& visitor);
  void markInside(const std::vector<Vec>& polygon);
  void add(const ReachWall& wall);
  void addOneways(std::span<const ReachWall> walls);
  void addBlocking(const ReachWall& wall);
  void addGround(const Line& line, bool sloped);
  void addSlowing(const Line& line, bool steep);
  void addCarrying(const ReachWall& wall);
  void addWedges(std::span<const ReachWall> walls);
  void addGoal(Vec goal);

  double cellSize_;
  Vec origin_;
  std::int32_t columns_ = 0;
  std::int32_t rows_ = 0;
  std::vector<Cell> cells_;
  std::vector<ReachOneway> oneways_;
  std::unordered_map<std::size_t, std::vector<ReachWall>> touched_;
};

}  // namespace platon
