#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "levels/reach/reach_flight.h"
#include "levels/reach/reach_grid.h"
#include "levels/reach/upright_faces.h"
#include "platon/game/level.h"

namespace platon {

/// The places that a player may reach, with any number of crossings, by the heights of its jumps alone: it may move
/// sideways as far as it likes in the air. Coarser and much faster than Reach. Over-approximates the game: a place that
/// is not reached here is not reached in the game, whatever is pressed. What Reach assumes of speeds is assumed here,
/// too, and that a way over an edge of the solid goes on in the nearest row of cells, or beside it if that is blocked.
class JumpHeights {
 public:
  struct Options {
    bool allDoorsOpen = false;              ///< else a door is open once one of its keys or plates can be touched
    std::vector<ElementWord> without = {};  ///< keys, plates or checkpoints that are not touched
    /// Asked every few milliseconds; when it returns true, the search ends unfinished.
    std::function<bool()> stop = {};
  };

  JumpHeights(const Level& level, const Options& options);

  /// Whether the search was stopped. Then a place that is not reached may still be in reach.
  bool isStopped() const { return stopped_; }
  /// Whether a player may touch the goal.
  bool reachesGoal() const { return reachesGoal_; }
  /// Whether the centre of a player may be at this place, with any up.
  bool reaches(std::uint32_t face, Point position) const;
  /// Whether a player may touch this segment of the face.
  bool touches(std::uint32_t face, const Segment& segment) const;

 private:
  struct Place {
    std::uint32_t node;
    std::size_t cell;
    Motion motion;
  };
  static constexpr double kNever = -1e300;
  static constexpr int kMaxHeight = 100;  // level units

  bool stops();
  void measure();
  void search(const Level& level);
  bool touches(std::uint32_t node, const Line& line) const;
  void put(const Place& place, double height);
  std::optional<Place> take();
  bool isOpen(std::uint32_t node, std::size_t cell) const;
  void fall(std::uint32_t node, std::size_t cell);
  void rise(std::uint32_t node, std::size_t cell, double apex);
  void dip(std::uint32_t node, std::size_t cell, double apex);
  void go(const Place& from, std::uint32_t node, std::size_t cell, double risen);
  void touch(const ReachWall& wall);
  void spread(const Place& place);
  void cross(const Place& place);

  UprightFaces faces_;
  Options options_;
  bool stopped_ = false;
  bool reachesGoal_ = false;
  bool hasHazard_ = false;
  double level_ = 0;  // most that a jump rises from level ground, and from a slope or an end
  double sloped_ = 0;
  double depth_ = 0;          // of a late jump below its highest point
  std::uint32_t opened_ = 0;  // bits of the doors that may be open
  std::vector<ReachGrid> grids_;
  std::vector<std::vector<double>> apexes_;              // of rises, by node and cell
  std::vector<std::vector<double>> dips_;                // apexes of what follows dips, by node and cell
  std::vector<std::vector<bool>> fallen_;                // by node and cell
  std::array<std::vector<Place>, kMaxHeight + 1> open_;  // by the height that is left to rise, the largest first
};

}  // namespace platon
