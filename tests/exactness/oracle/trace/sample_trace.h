#pragma once

#include <set>
#include <string>
#include <vector>

#include "tests/exactness/oracle/trace/trace.h"

namespace platon::oracle {

/// A small hand-made trace. Each test breaks it in one place.
struct SampleTrace {
  TraceHeader header;
  std::vector<TraceTick> ticks;

  /// The instances of leg `entry` of tick `tick`, both counted from 0.
  TraceLeg& leg(std::size_t tick, std::size_t entry) { return ticks[tick].players[0].legs[entry]; }
};

/// Half the edge length of the sample's faces, in subunits.
inline constexpr std::int64_t kSampleHalf = 204800;

/// A correct trace of a triangle on a hexahedron of size 400 with points as posts. In tick 0 the triangle rests; in
/// tick 1 it moves right until it reaches into the next face; in tick 2 its centre crosses the edge, so that it
/// rehomes; in tick 3 it leaves the first face.
SampleTrace sampleTrace();

/// The header of a solid. `faces` lists the corners of each face, counter-clockwise seen from outside.
TraceHeader makeHeader(const std::string& solid, const std::vector<std::vector<int>>& faces, std::int64_t size);

/// The instance that `parent` has behind a warp of the sample.
TraceInstance behindWarp(const TraceHeader& header, const TraceInstance& parent, std::size_t warp, std::int64_t id);

std::string toJson(const TraceHeader& header);
std::string toJson(const TraceTick& tick);

/// The rules that the checker finds violated in a trace.
std::set<std::string> violatedRules(const std::vector<std::string>& lines);
std::set<std::string> violatedRules(const SampleTrace& trace);

}  // namespace platon::oracle
