#pragma once

#include <memory>
#include <vector>

#include "tests/exactness/oracle/trace/trace.h"
#include "tests/exactness/oracle/trace/trace_report.h"

namespace platon::oracle {

/// A shape as turned by an instance's angle, with the box around it.
struct TurnedShape {
  Polygon polygon;
  Box box;
};

/// The shapes that instances had, by angle. Each is checked when it is met first: strictly convex and, vertex for
/// vertex, within 1 subunit of the base shape turned by exactly that angle. Met again it must be the same, since it is
/// a function of base shape and angle alone.
class ShapeLibrary {
 public:
  ShapeLibrary(const Polygon& base, TraceReport& report);

  /// The instance's shape: its own or, where it has none, the base shape. Stays where it is.
  const TurnedShape& of(const TraceInstance& instance);

 private:
  const TurnedShape& add(std::size_t angle, const Polygon& polygon);
  bool isTurnedBase(std::size_t angle, const Polygon& polygon) const;

  Polygon base_;
  TraceReport& report_;
  std::vector<std::unique_ptr<TurnedShape>> known_;  ///< by angle
};

}  // namespace platon::oracle
