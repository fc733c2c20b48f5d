#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/exactness/oracle/exact_geometry.h"

namespace platon::oracle {

/// A face's edge, and where the same two points lie in the face behind it.
struct TraceWarp {
  Segment from;
  std::int64_t to = 0;
  Segment onto;
};

struct TraceFace {
  Polygon polygon;
  std::vector<Segment> lines;
  std::vector<TraceWarp> warps;
};

/// First line of a trace.
struct TraceHeader {
  std::string solid;
  Polygon shape;
  std::vector<TraceFace> faces;
};

/// One placement of a player's shape. `shape` is empty unless the trace gives one.
struct TraceInstance {
  std::int64_t id = 0;
  std::int64_t face = 0;
  Vec position;
  std::int64_t angle = 0;
  bool home = true;
  std::int64_t parent = 0;  ///< where not home: id of the instance it hangs on
  std::int64_t warp = 0;    ///< where not home: index in the parent's face
  Polygon shape;

  friend bool operator==(const TraceInstance&, const TraceInstance&) = default;
};

/// All instances of one player at one moment.
using TraceLeg = std::vector<TraceInstance>;

struct TracePlayer {
  std::int64_t id = 0;
  std::vector<TraceLeg> legs;
};

/// Any further line of a trace.
struct TraceTick {
  std::int64_t tick = 0;
  std::string hash;
  std::vector<TracePlayer> players;
};

}  // namespace platon::oracle
