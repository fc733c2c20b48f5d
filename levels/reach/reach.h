#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "levels/reach/reach_flight.h"
#include "levels/reach/reach_grid.h"
#include "platon/game/level.h"

namespace platon {

/// Where a player can get, at most, and with how few crossings of edges. Over-approximates the game: a place that is
/// not reached here with n crossings is not reached in the game with n crossings, whatever is pressed. So it proves
/// that a level needs its crossings. A door counts as open once one of its keys or plates can be touched; on levels for
/// several players all doors are open.
///
/// What is assumed of a flight, by the rules of Player: it rises at most by the height of a jump above the ground from
/// which it started, and by what a slope gives; it moves sideways at most at the run speed, or the slide speed after a
/// steep segment; its time is bounded by the slowest rise and fall; no contact gives an upward speed, unless the player
/// can stand there.
class Reach {
 public:
  /// Searches for ways with at most `maxCrossings` crossings, below 255.
  Reach(const Level& level, int maxCrossings);

  /// The fewest crossings with which the goal may be reached; nothing when more than the maximum are needed.
  std::optional<int> crossingsToGoal() const { return toGoal_; }
  /// The fewest crossings with which a player may be at this place; nothing when it cannot be there.
  std::optional<int> crossingsTo(std::uint32_t face, Point position, Angle up) const;

 private:
  static constexpr std::uint8_t kUnreached = 255;

  // Cells from which flights start, in rising order: twice the cell, plus 1 in a one-way segment.
  using Starts = std::vector<std::uint32_t>;

  void search(const Level& level);
  void clear();
  void addFall(int crossings, std::uint32_t node, Vec place);
  void launchPending();
  void launchRuns(int crossings, std::uint32_t node, Starts starts);
  void launch(int crossings, std::uint32_t node, const Starts& run);
  void fly(int crossings, const ReachLaunch& launch);
  void visit(const ReachVisit& visit);
  void touch(const ReachVisit& visit, const ReachWall& wall);

  UprightFaces faces_;
  std::vector<std::unique_ptr<ReachGrid>> grids_;  // by node
  int maxCrossings_;
  bool hasHazard_ = false;
  std::vector<int> opened_;
  bool opensMore_ = false;
  std::vector<std::vector<ReachKnown>> known_;
  std::vector<std::vector<std::uint8_t>> reached_;  // fewest crossings, by node and cell
  // Fewest crossings of a start, by node and start.
  std::vector<std::vector<std::uint8_t>> launched_;
  std::map<int, std::map<std::uint32_t, Starts>> pending_;
  std::optional<int> toGoal_;
};

}  // namespace platon
