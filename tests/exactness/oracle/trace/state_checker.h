#pragma once

#include <optional>

#include "tests/exactness/oracle/sweep/shape_library.h"
#include "tests/exactness/oracle/trace/trace_map.h"

namespace platon::oracle {

/// The instance that hangs on nothing; nullptr when there is none.
const TraceInstance* homeOf(const TraceLeg& leg);

/// The instance with this id; nullptr when there is none.
const TraceInstance* findInstance(const TraceLeg& leg, std::int64_t id);

/// Checks the instances of one player at one moment.
class StateChecker {
 public:
  StateChecker(const TraceMap& map, ShapeLibrary& shapes, TraceReport& report)
      : map_(map), shapes_(shapes), report_(report) {}

  /// One home, every other instance hangs on it by a chain of existing warps, ids differ. When not, nothing else can be
  /// judged.
  bool isTree(const TraceLeg& leg);
  /// Every instance lies where its warps put it, no two in one place (I5), and none is missing.
  void checkPlacements(const TraceLeg& leg);
  /// The open interior of the instance meets no line of its face (I1).
  void checkFree(const TraceInstance& instance);
  /// The home face holds the centre (I7), and no instance stays behind an edge that the shape has left.
  void checkTickEnd(const TraceLeg& leg);

  /// From the frame of the home instance to that of `instance`, as the ideal faces lie.
  Isometry motionFromHome(const TraceLeg& leg, const TraceInstance& instance) const;

 private:
  const MapWarp& warpOf(const TraceLeg& leg, const TraceInstance& instance) const;
  RealVec placeFromHome(const TraceLeg& leg, const TraceInstance& instance) const;
  bool isWellFormed(const TraceLeg& leg, const TraceInstance& instance);
  bool reachesHome(const TraceLeg& leg, const TraceInstance& instance) const;
  void checkPlacement(const TraceLeg& leg, const TraceInstance& instance);
  void checkDuplicates(const TraceLeg& leg);
  void checkCoverage(const TraceLeg& leg, const TraceInstance& instance);
  bool isCovered(const TraceLeg& leg, const TraceInstance& instance, std::size_t warp) const;
  bool reachesThrough(const TraceInstance& instance, const MapWarp& warp);
  bool isStale(const TraceLeg& leg, const TraceInstance& instance);

  const TraceMap& map_;
  ShapeLibrary& shapes_;
  TraceReport& report_;
};

}  // namespace platon::oracle
