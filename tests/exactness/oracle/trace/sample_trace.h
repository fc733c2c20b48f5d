#pragma once

#include <set>
#include <string>
#include <vector>

#include "tests/exactness/oracle/trace/trace.h"

namespace platon::oracle {

/// A small trace made by hand, to be broken in one place by each test.
struct SampleTrace {
  TraceHeader header;
  std::vector<TraceTick> ticks;

  /// The instances of leg entry `leg` of tick `tick`, counted from 0.
  TraceLeg& leg(std::size_t tick, std::size_t entry) { return ticks[tick].players[0].legs[entry]; }
};

/// Half the edge of the sample's faces, in subunits: where its edges are.
inline constexpr std::int64_t kSampleHalf = 204800;

/// A hexahedron of size 400 with point posts and a triangle, which lies still for a tick (0), goes right until it
/// reaches into the next face (1), goes on until its centre and so its home is there (2), and goes on until it has left
/// the first face (3). Everything in it is right.
SampleTrace sampleTrace();

/// The header of a solid by the corners of its faces, counter-clockwise seen from outside.
TraceHeader makeHeader(const std::string& solid, const std::vector<std::vector<int>>& faces, std::int64_t size);

/// Where an instance at `position`, turned by `angle`, stands when it is seen from behind a warp of the sample.
TraceInstance behindWarp(const TraceHeader& header, const TraceInstance& parent, std::size_t warp, std::int64_t id);

std::string toJson(const TraceHeader& header);
std::string toJson(const TraceTick& tick);

/// What the checker finds broken in the trace made of these lines, or of the sample.
std::set<std::string> brokenLaws(const std::vector<std::string>& lines);
std::set<std::string> brokenLaws(const SampleTrace& trace);

}  // namespace platon::oracle
