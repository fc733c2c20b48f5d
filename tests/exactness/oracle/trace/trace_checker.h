#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string_view>

#include "tests/exactness/oracle/trace/motion_checker.h"

namespace platon::oracle {

/// Checks a trace line by line, keeping no more than the end of the last tick. Knows the laws of the world but nothing
/// of how it is solved.
class TraceChecker {
 public:
  TraceChecker() = default;
  TraceChecker(const TraceChecker&) = delete;
  TraceChecker& operator=(const TraceChecker&) = delete;

  /// Takes the next line, without its line feed. False when the rest of the trace cannot be judged.
  bool take(std::string_view line);
  /// Says that there are no more lines.
  void finish();

  const TraceReport& report() const { return report_; }

 private:
  /// What is made from the header.
  struct Checkers {
    Checkers(TraceMap header, TraceReport& report)
        : map(std::move(header)),
          shapes(map.shape(), report),
          states(map, shapes, report),
          motions(map, shapes, states, report) {}

    TraceMap map;
    ShapeLibrary shapes;
    StateChecker states;
    MotionChecker motions;
  };

  bool takeHeader(std::string_view line);
  bool takeTick(std::string_view line);
  void takePlayer(const TracePlayer& player, std::map<std::int64_t, TraceLeg>& now);
  bool takeStart(const TracePlayer& player);
  bool takeLeg(const TraceLeg& before, const TraceLeg& after);

  TraceReport report_;
  std::unique_ptr<Checkers> checkers_;
  std::optional<std::int64_t> lastTick_;
  std::map<std::int64_t, TraceLeg> last_;  ///< end of the last tick, by player
};

}  // namespace platon::oracle
