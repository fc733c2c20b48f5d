#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "levels/reach/flight_envelope.h"
#include "levels/reach/reach_grid.h"
#include "levels/reach/upright_faces.h"

namespace platon {

/// Where a flight starts: neighbouring cells of one row.
struct ReachLaunch {
  std::uint32_t node = 0;
  bool rising = false;    ///< a jump; else a fall from rest
  bool inOneway = false;  ///< the player may overlap a one-way segment
  double speed = 0;       ///< largest horizontal speed at the start
  double apex = 0;        ///< highest y, in the frame of the node
  std::vector<std::uint32_t> cells;
};

/// What a player in the air does. A dip is the fall before a late jump: from there it may rise.
enum class Motion : std::uint8_t { kFall, kRise, kDip };

/// A cell that a flight visits.
struct ReachVisit {
  std::uint32_t node = 0;
  std::uint32_t cell = 0;
  int crossings = 0;  ///< of the whole way
  Vec shift;          ///< added to a point in the frame of the launch, gives the point in that of the node
  Motion motion = Motion::kFall;
  bool inOneway = false;
  double speed = 0;      ///< largest horizontal speed that the player may have
  bool isBelow = false;  ///< so nearly below the launch that a fall from here reaches nothing more
};

/// The widest flight that has visited a cell, as far as it is known. One that can do no more need not go on.
struct ReachKnown {
  float left = 1e30F;    ///< smallest x that it may reach at this height, in the frame of the node
  float right = -1e30F;  ///< largest
  float apex = 0;
  float speed = 0;    ///< horizontal speed that it may have if it is in the cell as late as it may be
  float landing = 0;  ///< and if it is as early
  std::uint8_t crossings = 255;
};

/// Visits all cells that a flight may reach from one launch, those with the fewest crossings first.
class ReachFlight {
 public:
  /// What the flight may use.
  struct World {
    const UprightFaces& faces;
    const std::vector<std::unique_ptr<ReachGrid>>& grids;
    std::uint32_t open;                           ///< bits of the open doors
    std::vector<std::vector<ReachKnown>>& known;  ///< by node and cell: of a fall, of a rise
    int maxCrossings = 0;
  };

  ReachFlight(const World& world, const ReachLaunch& launch, int crossings);
  /// The rest of a flight with this launch, from cells that it has visited, all with as many crossings.
  ReachFlight(const World& world, const ReachLaunch& launch, std::span<const ReachVisit> visited);

  /// Calls visitor(ReachVisit) for every cell, at least once.
  template <class Visitor>
  void run(Visitor&& visitor) {
    for (; crossings_ <= world_.maxCrossings && !waiting_.empty(); ++crossings_) {
      isRunning_ = true;
      open_.swap(waiting_);
      waiting_.clear();
      while (!open_.empty()) {
        const State state = open_.back();
        open_.pop_back();
        const Sheet& sheet = sheets_[state.sheet];
        visitor(ReachVisit{sheet.node, state.cell, crossings_, sheet.shift, state.motion, state.inOneway,
                           speedIn(state), isBelow(state)});
        spread(state);
      }
    }
  }

 private:
  struct State {
    std::uint32_t sheet = 0;
    std::uint32_t cell = 0;
    Motion motion = Motion::kFall;
    bool inOneway = false;
  };
  // A face in the plane into which the flight unfolds the faces.
  struct Sheet {
    std::uint32_t node = 0;
    Vec shift;  // added to a point in the frame of the launch, gives the point in that of the node
    std::vector<std::uint8_t> seen;
  };

  void prepare(const ReachLaunch& launch);
  void spread(const State& state);
  void step(const State& from, std::size_t cell);
  void cross(const State& from);
  void enter(int crossings, const State& state);
  bool isFree(const State& state) const;
  bool isBelow(const State& state) const;
  double asideOf(const State& state) const;
  double speedIn(const State& state) const { return envelope_.speedAfterWay(asideOf(state), speed_); }
  bool isInTime(int crossings, const State& state);
  bool isInTimeForALateJump(const State& state) const;
  std::uint32_t sheetOf(std::uint32_t node, Vec shift);
  const ReachGrid& gridOf(const State& state) const { return *world_.grids[sheets_[state.sheet].node]; }

  World world_;
  const FlightEnvelope& envelope_ = FlightEnvelope::measured();
  double left_ = 0;  // of the launch
  double right_ = 0;
  double apex_ = 0;
  double speed_ = 0;
  double low_ = 0;       // lower side of its cells
  int launchTicks_ = 0;  // until a fall begins
  int crossings_;
  std::vector<Sheet> sheets_;
  bool isRunning_ = false;
  std::vector<State> open_;
  std::vector<State> waiting_;  // with one crossing more
};

}  // namespace platon
