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
    oracle::Vec start, end;
    bool alongLine;             ///< parallel to the segment; never if that is a point
    std::size_t before, after;  ///< indices of the adjacent sides

    /// The way of a displacement from `start` towards `end`, times the length of (x, y).
    mpz_class ahead(const mpz_class& vx, const mpz_class& vy) const { return x * vy - y * vx; }
    /// The way of a displacement inwards, times the length of (x, y).
    mpz_class inwards(const mpz_class& vx, const mpz_class& vy) const { return -x * vx - y * vy; }
  };

  PathObstacle(const oracle::Polygon& shape, const oracle::Segment& line);

  std::vector<Side> sides;
  oracle::Box box;
};

}  // namespace platon::reference
