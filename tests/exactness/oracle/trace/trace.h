#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/exactness/oracle/exact_geometry.h"

namespace platon::oracle {

/// An edge of a face, and the same edge in the frame of the adjacent face `to`.
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

/// A line with a word. `k` is the number after the word; -1 if there is none.
struct TraceElement {
  std::int64_t face = 0;
  std::int64_t line = 0;  ///< index into the lines of the face
  std::string word;
  std::int64_t k = -1;
  std::int64_t k2 = -1;
};

/// First line of a trace.
struct TraceHeader {
  std::string solid;
  Polygon shape;
  std::vector<TraceFace> faces;
  std::vector<TraceElement> elements = {};
};

/// One placement of a player's shape. `shape` is empty if the trace gives none.
struct TraceInstance {
  std::int64_t id = 0;
  std::int64_t face = 0;
  Vec position;
  std::int64_t angle = 0;
  bool home = true;
  std::int64_t parent = 0;  ///< unless home: id of the parent instance
  std::int64_t warp = 0;    ///< unless home: index of the warp in the parent's face
  Polygon shape;

  friend bool operator==(const TraceInstance&, const TraceInstance&) = default;
};

/// All instances of one player after one leg of its step.
using TraceLeg = std::vector<TraceInstance>;

struct TracePlayer {
  std::int64_t id = 0;
  std::vector<TraceLeg> legs;
};

/// Every other line of a trace: one tick.
struct TraceTick {
  std::int64_t tick = 0;
  std::string hash;
  std::vector<TracePlayer> players;
  std::vector<std::int64_t> open = {};  ///< indices of the doors, among the elements, that are open during the tick
};

}  // namespace platon::oracle
