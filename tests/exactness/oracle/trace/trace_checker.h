#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string_view>

#include "tests/exactness/oracle/trace/motion_checker.h"

namespace platon::oracle {

/// Checks a trace line by line; keeps only the last state of each player. It knows the invariants of the simulation,
/// but not its algorithm.
class TraceChecker {
 public:
  TraceChecker() = default;
  TraceChecker(const TraceChecker&) = delete;
  TraceChecker& operator=(const TraceChecker&) = delete;

  /// Checks the next line, given without its line feed. Returns false if the rest of the trace cannot be checked.
  bool checkLine(std::string_view line);
  /// Call after the last line.
  void finish();

  const TraceReport& report() const { return report_; }

 private:
  /// The checkers that the header determines.
  struct Checkers {
    Checkers(TraceMap header, TraceReport& report)
        : map(std::move(header)),
          shapes(map.shape(), report),
          blocking(map, shapes, report),
          states(map, shapes, blocking, report),
          motions(map, shapes, blocking, states, report) {}

    TraceMap map;
    ShapeLibrary shapes;
    Blocking blocking;
    StateChecker states;
    MotionChecker motions;
  };

  bool checkHeader(std::string_view line);
  bool checkTick(std::string_view line);
  void checkPlayer(const TracePlayer& player, std::map<std::int64_t, TraceLeg>& now);
  bool checkStart(const TracePlayer& player);
  bool isReturn(const TraceLeg& earlier, const TraceLeg& start) const;
  bool checkLeg(const TraceLeg& before, const TraceLeg& after);

  TraceReport report_;
  std::unique_ptr<Checkers> checkers_;
  std::optional<std::int64_t> lastTick_;
  std::map<std::int64_t, TraceLeg> last_;  ///< last leg of the last tick, by player
  std::optional<TraceInstance> first_;     ///< home of the first player: all begin at the start of the level
};

}  // namespace platon::oracle
