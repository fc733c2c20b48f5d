#pragma once

#include "tests/exactness/oracle/trace/state_checker.h"

namespace platon::oracle {

/// Checks how the instances of one player went from one moment to the next. Both must be trees.
class MotionChecker {
 public:
  MotionChecker(const TraceMap& map, ShapeLibrary& shapes, StateChecker& states, TraceReport& report)
      : map_(map), shapes_(shapes), states_(states), report_(report) {}

  /// Every instance goes straight and free (I1), turns free, and moves as home does (I6). Home passes only where
  /// nothing moves.
  void check(const TraceLeg& before, const TraceLeg& after);

 private:
  /// What the instance that is home afterwards did.
  struct HomeMove {
    bool passes = false;
    Vec step;
    std::int64_t turn = 0;
  };

  static HomeMove moveOfHome(const TraceLeg& before, const TraceLeg& after);
  void checkHomePassing(const TraceLeg& before, const TraceLeg& after);
  void checkOld(const TraceLeg& leg, const TraceInstance& before, const TraceInstance& after, const HomeMove& home);
  void checkNew(const TraceLeg& leg, const TraceInstance& instance, const HomeMove& home);
  void checkStays(const TraceInstance& before, const TraceInstance& after);
  void checkTogether(const TraceLeg& leg, const TraceInstance& before, const TraceInstance& after,
                     const HomeMove& home);
  void checkTurn(const TraceInstance& before, const TraceInstance& after);
  /// `tolerance`: how far, in subunits, the sides of the shape are moved inwards first.
  void checkPath(const TraceInstance& from, const TraceInstance& shaped, Vec displacement, std::int64_t tolerance);
  Vec stepOf(const TraceLeg& leg, const TraceInstance& instance, Vec homeStep) const;

  const TraceMap& map_;
  ShapeLibrary& shapes_;
  StateChecker& states_;
  TraceReport& report_;
};

}  // namespace platon::oracle
