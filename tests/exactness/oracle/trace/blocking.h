#pragma once

#include <vector>

#include "tests/exactness/oracle/trace/shape_library.h"
#include "tests/exactness/oracle/trace/trace_map.h"

namespace platon::oracle {

/// Which segments block a mover at a tick. What the words mean is written from docs/level_format.md.
class Blocking {
 public:
  Blocking(const TraceMap& map, ShapeLibrary& shapes, TraceReport& report)
      : map_(map), shapes_(shapes), report_(report), isOpen_(map.elements().size()) {}

  /// Sets what is open in the tick after `tick` ticks, by the indices of the elements. Only doors and timed segments
  /// open, each is listed once; doors of one number are open together, and timed segments as the clock says.
  void setOpen(const std::vector<std::int64_t>& open, std::int64_t tick);

  /// Whether `line`, of the face of the instance, may not be overlapped by an instance that arrives in this place. A
  /// one-way segment is never in the way of an instance that overlaps it: such an instance is not on its left side.
  bool forbids(const MapLine& line, const TraceInstance& instance);
  /// Whether it blocks a move that begins in this place. What the instance overlaps there does not count until the
  /// instance has left it, unless it blocks always.
  bool blocks(const MapLine& line, const TraceInstance& start);
  /// Whether it blocks everybody at every tick.
  bool blocksAlways(const MapLine& line) const;

 private:
  bool isOnLeftSide(const Segment& segment, const TraceInstance& instance);
  bool pointsUpTo(std::int64_t edge, const TraceInstance& instance) const;
  bool overlaps(const MapLine& line, const TraceInstance& instance);

  const TraceMap& map_;
  ShapeLibrary& shapes_;
  TraceReport& report_;
  std::vector<bool> isOpen_;  ///< by element
};

}  // namespace platon::oracle
