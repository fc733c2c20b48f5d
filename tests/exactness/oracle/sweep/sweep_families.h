#pragma once

#include <span>
#include <string_view>

#include "tests/exactness/oracle/random_source.h"
#include "tests/exactness/oracle/sweep/sweep_query.h"

namespace platon::oracle {

/// What the polygon is like.
enum class ShapeKind { Any, Many, Ball, Needle, Box };

/// What the obstacle is like, where `Along`, `Copy` and `Almost` mean: parallel to an edge of the polygon, as long as
/// it, and one subunit off parallel.
enum class LineKind { Any, Point, Along, Copy, Almost };

/// How position and displacement are chosen in respect of the forbidden polygon O.
enum class Aim {
  Anywhere,     ///< both at random
  Towards,      ///< the end is near a random corner of O
  Corner,       ///< exactly through a corner of O, or one subunit beside it
  Edge,         ///< along the line of an edge of O, or one subunit beside it
  Tangent,      ///< touches O in one corner only
  Starting,     ///< starts on the boundary of O: in, out or along
  Ending,       ///< ends on the boundary of O, or one subunit before or behind it
  Overlapping,  ///< starts inside O
  Still,        ///< no displacement; on the boundary, inside or outside
  AlmostAlong,  ///< one subunit off parallel to an edge of O, close to it
};

/// One kind of queries: every number is about `scale` or less.
struct SweepFamily {
  std::string_view name;
  std::int64_t scale;
  ShapeKind shape;
  LineKind line;
  Aim aim;
};

/// All families that the sweep check asks.
std::span<const SweepFamily> sweepFamilies();

/// A valid random query of the family.
SweepQuery makeQuery(const SweepFamily& family, RandomSource& random);

}  // namespace platon::oracle
