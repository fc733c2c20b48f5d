#pragma once

#include "tests/exactness/oracle/trace/state_checker.h"

namespace platon::oracle {

/// Checks how the instances of one player moved between two consecutive legs. Both must be trees.
class MotionChecker {
 public:
  MotionChecker(const TraceMap& map, ShapeLibrary& shapes, Blocking& blocking, StateChecker& states,
                TraceReport& report)
      : map_(map), shapes_(shapes), blocking_(blocking), states_(states), report_(report) {}

  /// The straight path and the rotation of every instance are free (I1), and every instance moves like the home
  /// instance (I6). In a leg that rehomes nothing moves.
  void check(const TraceLeg& before, const TraceLeg& after);

 private:
  /// The motion of the instance that is home after the leg.
  struct HomeMove {
    bool rehomes = false;
    Vec step;
    std::int64_t turn = 0;
  };

  static HomeMove moveOfHome(const TraceLeg& before, const TraceLeg& after);
  void checkRehome(const TraceLeg& before, const TraceLeg& after);
  void checkKeptInstance(const TraceLeg& leg, const TraceInstance& before, const TraceInstance& after,
                         const HomeMove& home);
  void checkNewInstance(const TraceLeg& leg, const TraceInstance& instance, const HomeMove& home);
  void checkUnmoved(const TraceInstance& before, const TraceInstance& after);
  void checkMovesWithHome(const TraceLeg& leg, const TraceInstance& before, const TraceInstance& after,
                          const HomeMove& home);
  void checkRotation(const TraceInstance& before, const TraceInstance& after);
  /// `tolerance`: distance in subunits by which the sides of the swept area are moved inwards first.
  void checkPath(const TraceInstance& from, const TraceInstance& shaped, Vec displacement, std::int64_t tolerance);
  Vec stepOf(const TraceLeg& leg, const TraceInstance& instance, Vec homeStep) const;

  const TraceMap& map_;
  ShapeLibrary& shapes_;
  Blocking& blocking_;
  StateChecker& states_;
  TraceReport& report_;
};

}  // namespace platon::oracle
