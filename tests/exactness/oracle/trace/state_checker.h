#pragma once

#include <optional>

#include "tests/exactness/oracle/trace/blocking.h"
#include "tests/exactness/oracle/trace/shape_library.h"
#include "tests/exactness/oracle/trace/trace_map.h"

namespace platon::oracle {

/// The home instance; nullptr if there is none.
const TraceInstance* homeOf(const TraceLeg& leg);

/// The instance with this id; nullptr if there is none.
const TraceInstance* findInstance(const TraceLeg& leg, std::int64_t id);

/// Checks the instances of one player after one leg.
class StateChecker {
 public:
  StateChecker(const TraceMap& map, ShapeLibrary& shapes, Blocking& blocking, TraceReport& report)
      : map_(map), shapes_(shapes), blocking_(blocking), report_(report) {}

  /// There is one home instance, a chain of existing warps connects every other instance to it, and all ids differ. If
  /// this is false, the other checks must not be called.
  bool isTree(const TraceLeg& leg);
  /// Every instance is where its warps place it (I5), no two are the same placement, and none is missing.
  void checkPlacements(const TraceLeg& leg);
  /// The open interior of the instance intersects no segment of its face that blocks it (I1). An instance that has
  /// just `arrived` overlaps no closed door either.
  void checkFree(const TraceInstance& instance, bool arrived);
  /// The centre is in the home face (I7), and no instance remains behind an edge that the shape has left.
  void checkTickEnd(const TraceLeg& leg);

  /// The ideal motion from the frame of the home instance to that of `instance`.
  Isometry motionFromHome(const TraceLeg& leg, const TraceInstance& instance) const;

 private:
  const MapWarp& warpOf(const TraceLeg& leg, const TraceInstance& instance) const;
  RealVec positionFromHome(const TraceLeg& leg, const TraceInstance& instance) const;
  bool isWellFormed(const TraceLeg& leg, const TraceInstance& instance);
  bool isConnectedToHome(const TraceLeg& leg, const TraceInstance& instance) const;
  void checkPlacement(const TraceLeg& leg, const TraceInstance& instance);
  void checkDuplicates(const TraceLeg& leg);
  void checkCoverage(const TraceLeg& leg, const TraceInstance& instance);
  bool isCovered(const TraceLeg& leg, const TraceInstance& instance, std::size_t warp) const;
  bool reachesThrough(const TraceInstance& instance, const MapWarp& warp);
  bool isStale(const TraceLeg& leg, const TraceInstance& instance);

  const TraceMap& map_;
  ShapeLibrary& shapes_;
  Blocking& blocking_;
  TraceReport& report_;
};

}  // namespace platon::oracle
