#pragma once

#include <string>
#include <vector>

#include "platon/physics/convex.h"
#include "platon/physics/segment.h"

namespace platon::bench {

/// A query: when does the shape, moving from `position` by `displacement`, first hit the segment?
struct SweepQuery {
  std::size_t shape = 0;  ///< index into the shapes of the set
  Point position;
  Point displacement;
  Segment segment;
};

struct SweepSet {
  std::string name;
  double subunitsPerMetre = 16384;
  std::vector<Convex> shapes;  ///< with eight vertices, in random-12-gon with twelve
  std::vector<SweepQuery> queries;
};

/// Sets of typical queries of a fast character, and of queries that are hard for engines. 16 384 subunits are one
/// metre:
///   random, random-12-gon     near the shape: about a quarter are hits
///   grazing                   past an end or along a side, within two subunits
///   end-point                 straight at an end of the segment, across it or up to it, within two subunits
///   far-1e3, far-1e5          like random, at this distance from the origin in metres; far-1e5 has 4 096 subunits per
///                             metre, because 16 384 would exceed the coordinate range at 32 768 m
///   long-lines, short-lines   segments of 10 000 m and of 8 subunits
///   touching                  the shape touches the segment at the start
///   full-range                coordinates of up to 2^29
///   slivers                   segments and displacements of up to 2^28, 1e-17 to 1e-13 rad off parallel, that end just
///                             before or just beyond the segment
std::vector<SweepSet> sweepSets(std::size_t queries);

}  // namespace platon::bench
