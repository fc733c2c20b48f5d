#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <vector>

#include "tests/exactness/oracle/exact_geometry.h"
#include "tests/exactness/reference/rational_vec.h"

namespace platon::reference {

/// The rational point (x / d, y / d), with d > 0 and without a common divisor.
struct Place {
  mpz_class x;
  mpz_class y;
  mpz_class d{1};

  RationalVec rational() const;
};

/// A rational number above or below zero: numerator / denominator, denominator > 0, not reduced.
struct Quotient {
  mpz_class numerator;
  mpz_class denominator{1};

  friend bool operator<(const Quotient& a, const Quotient& b) {
    return a.numerator * b.denominator < b.numerator * a.denominator;
  }
  friend bool operator==(const Quotient& a, const Quotient& b) {
    return a.numerator * b.denominator == b.numerator * a.denominator;
  }
};

/// The positions at which a body overlaps a segment: an open convex polygon.
struct PathObstacle {
  /// A side: (x, y) . p < bound inside. The inside is to the left of the way from `start` to `end`.
  struct Side {
    mpz_class x, y, bound;
    Place start, end;
    bool alongLine;             ///< parallel to the segment
    std::size_t before, after;  ///< indices of the adjacent sides

    /// The direction from `start` to `end`: (-y, x).
    mpz_class ahead(const mpz_class& vx, const mpz_class& vy) const { return x * vy - y * vx; }
    mpz_class inwards(const mpz_class& vx, const mpz_class& vy) const { return -x * vx - y * vy; }
  };

  /// Every side is moved outwards by `grown` subunits (inwards if negative), rounded away from zero by less than a
  /// subunit divided by the length of its normal. Throws std::runtime_error if a side vanishes.
  PathObstacle(const oracle::Polygon& shape, const oracle::Segment& line, std::int64_t grown);

  std::vector<Side> sides;
  double lowX, lowY, highX, highY;  ///< a box around it, larger by at least half a subunit
};

}  // namespace platon::reference
