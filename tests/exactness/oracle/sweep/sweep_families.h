#pragma once

#include <span>
#include <string_view>

#include "tests/exactness/oracle/random_source.h"
#include "tests/exactness/oracle/sweep/sweep_query.h"

namespace platon::oracle {

/// Kind of polygon.
enum class ShapeKind { Any, ManyVertices, Ball, Needle, Box };

/// Kind of segment.
enum class SegmentKind {
  Any,
  Point,
  Parallel,        ///< parallel to an edge of the polygon
  EdgeCopy,        ///< parallel to an edge of the polygon, and as long
  NearlyParallel,  ///< one subunit off parallel to an edge of the polygon
};

/// How position and displacement are chosen relative to the obstacle O.
enum class Aim {
  Random,            ///< both at random
  EndsNearVertex,    ///< the end is near a vertex of O
  ThroughVertex,     ///< exactly through a vertex of O, or one subunit beside it
  AlongEdge,         ///< along an edge of O, or one subunit beside it
  Tangent,           ///< touches O in one vertex only
  StartsOnBoundary,  ///< starts on the boundary of O, in any direction
  EndsOnBoundary,    ///< ends on the boundary of O, or one subunit beside it
  StartsInside,      ///< starts inside O
  NoDisplacement,    ///< on the boundary of O, inside or outside
  NearlyAlongEdge,   ///< close to an edge of O, and up to two subunits off parallel to it
};

/// A family of queries whose numbers are at most about `scale`.
struct SweepFamily {
  std::string_view name;
  std::int64_t scale;
  ShapeKind shape;
  SegmentKind segment;
  Aim aim;
};

/// All families of the sweep check.
std::span<const SweepFamily> sweepFamilies();

/// A valid random query of the family.
SweepQuery makeQuery(const SweepFamily& family, RandomSource& random);

}  // namespace platon::oracle
