#pragma once

#include <memory>
#include <vector>

#include "tests/exactness/oracle/trace/trace.h"
#include "tests/exactness/oracle/trace/trace_report.h"

namespace platon::oracle {

/// A shape rotated by an instance's angle, and its bounding box.
struct RotatedShape {
  Polygon polygon;
  Box box;
};

/// The shapes of all instances so far, by angle. The first shape at an angle is checked: it must be strictly convex,
/// and each vertex within 1 subunit of the base shape's vertex rotated by exactly that angle. Later shapes at that
/// angle must equal it, because a shape depends on base shape and angle only.
class ShapeLibrary {
 public:
  ShapeLibrary(const Polygon& base, TraceReport& report);

  /// The shape of the instance: its own, or the base shape if it has none. The reference stays valid.
  const RotatedShape& of(const TraceInstance& instance);

 private:
  const RotatedShape& add(std::size_t angle, const Polygon& polygon);
  bool isRotatedBase(std::size_t angle, const Polygon& polygon) const;

  Polygon base_;
  TraceReport& report_;
  std::vector<std::unique_ptr<RotatedShape>> known_;  ///< by angle
};

}  // namespace platon::oracle
