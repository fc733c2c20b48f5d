#pragma once

#include <string>
#include <vector>

#include "platon/physics/convex.h"
#include "platon/physics/segment.h"

namespace platon::bench {

/// One question: where does the shape, at `position` and moved by `displacement`, first meet the line?
struct SweepQuestion {
  std::size_t shape = 0;  ///< index into the shapes of the set
  Point position;
  Point displacement;
  Segment line;
};

struct SweepSet {
  std::string name;
  double subunitsPerMetre = 16384;
  std::vector<Convex> shapes;  ///< of eight vertices, or twelve where the name says so
  std::vector<SweepQuestion> questions;
};

/// What a fast character asks, and what breaks engines. 16 384 subunits are one metre:
///   random, random-12-gon     anywhere near: about a quarter meets
///   grazing                   past an end or along a side, give or take two subunits
///   end-point                 straight at an end of the line, over it or up to it, give or take two subunits
///   far-1e3, far-1e5          as random, so many metres from the origin; the last at 4 096 subunits a metre, for at
///                             16 384 the coordinates would leave their range at 32 768 m
///   long-lines, short-lines   of 10 000 m and of one to nine subunits
///   touching                  touching the line at the start
///   full-range                every coordinate anywhere below 2^29
///   slivers                   lines and displacements of up to 2^28, 1e-17 to 1e-13 rad from parallel, that end just
///                             before or just behind the line
std::vector<SweepSet> sweepSets(std::size_t questions);

}  // namespace platon::bench
