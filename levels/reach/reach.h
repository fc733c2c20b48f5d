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
/// not reached here with n crossings is not reached in the game with n crossings, whatever is pressed, as long as what
/// is assumed below holds. So it proves that a level needs its crossings. A door is open from where one of its keys or
/// plates was touched, and for ever; on levels for several players, and of more than kMaxNumbers numbers those beyond,
/// from the start. A door without keys and plates is never open. More players than the level needs may get farther.
///
/// What is assumed of a flight, by the rules of Player: it rises at most by the height of a jump above the ground from
/// which it started, and by what a slope gives, also when it is late and has fallen before; it moves sideways at most
/// at the speed with which it started: that of a run, of a slide down a steep segment as far as its slope lets, or that
/// with which the player landed before, less what a tick on the ground takes; a landing gives no horizontal speed; the
/// time of a flight is bounded by the slowest rise and fall; no contact gives an upward speed, unless the player can
/// stand there. reach_law_test searches the game itself for places that this denies.
///
/// One thing that the game does is left out: a rise that meets a slope or an end from below is turned aside, up to 1.6
/// times as fast as a run by one contact, and faster by several. It gets no farther by this, as far as is known, but it
/// may land faster than is assumed here. What is proved holds as long as no way gains by such a landing.
class Reach {
 public:
  /// Searches for ways with at most `maxCrossings` crossings, below 255, that touch none of the elements `without`:
  /// keys, plates or checkpoints.
  Reach(const Level& level, int maxCrossings, std::vector<ElementWord> without = {});
  /// As many numbers of doors are told apart: the time doubles with each.
  static constexpr int kMaxNumbers = 4;

  /// The fewest crossings with which the goal may be reached; nothing when more than the maximum are needed.
  std::optional<int> crossingsToGoal() const { return toGoal_; }
  /// The fewest crossings with which a player may be at this place; nothing when it cannot be there.
  std::optional<int> crossingsTo(std::uint32_t face, Point position, Angle up) const;

 private:
  static constexpr std::uint8_t kUnreached = 255;

  // Cells from which flights start: the kind of the start times the cells of the grid, plus the cell. The kind is four
  // times the pace, plus 2 for a jump, plus 1 in a one-way segment.
  using Starts = std::vector<std::uint32_t>;
  static constexpr std::uint32_t kKinds = 4 * FlightEnvelope::kPaces;

  // Fewest crossings of a fall from a checkpoint, by the checkpoint and the node of its face.
  using Respawned = std::map<std::pair<const Element*, std::uint32_t>, int>;

  // A flight that has opened a door: it goes on from where it touched the key, in these cells.
  struct Resumed {
    ReachLaunch launch;
    std::vector<ReachVisit> visits;
  };
  // What was visited with one set of doors open. A later visit with more of them open is another one.
  struct Phase {
    std::uint32_t open = 0;
    std::vector<std::vector<ReachKnown>> known;
    std::vector<std::vector<std::uint8_t>> launched;  // fewest crossings of a start, by node and start
    std::map<int, std::map<std::uint32_t, Starts>> pending;
    Respawned respawned;
  };

  bool startsAtDoor(const Level& level) const;
  bool opensDoors(const Element& element) const;
  void setDoors(const Level& level);
  void begin(std::uint32_t open);
  void resume(const std::vector<Resumed>& resumed);
  void launchPending();
  bool isTooFar(int crossings) const { return toGoal_ && crossings >= *toGoal_; }
  void addFall(int crossings, std::uint32_t node, Vec place);
  void launchRuns(int crossings, std::uint32_t node, Starts starts);
  void launch(int crossings, std::uint32_t node, const Starts& run);
  void fly(ReachFlight flight, const ReachLaunch& launch);
  void visit(const ReachVisit& visit);
  void addStarts(const ReachVisit& visit, const ReachGrid::Cell& cell);
  void addStart(const ReachVisit& visit, int pace, bool rising);
  bool isOutdone(std::uint32_t node, std::uint32_t start, int crossings) const;
  void respawn(int crossings, const Element& checkpoint, std::uint32_t node);
  std::uint32_t openedBy(const ReachVisit& visit) const;
  ReachFlight::World world() { return {faces_, grids_, phase_.open, phase_.known, maxCrossings_}; }

  UprightFaces faces_;
  std::vector<std::unique_ptr<ReachGrid>> grids_;  // by node
  int maxCrossings_;
  std::vector<ElementWord> without_;
  Vec start_;  // in the frame of node 0
  bool hasHazard_ = false;
  bool startsAtDoor_ = false;
  std::uint32_t open_ = 0;      // doors that are open from the start
  std::uint32_t openable_ = 0;  // doors that keys and plates open
  Phase phase_;
  std::map<std::uint32_t, std::vector<Resumed>> resumed_;  // by the doors that are open
  std::map<std::uint32_t, Respawned> respawned_;           // of the phases before, by the doors that are open
  std::vector<std::vector<std::uint8_t>> reached_;         // fewest crossings, by node and cell
  std::optional<int> toGoal_;
};

}  // namespace platon
