#pragma once

#include <string>
#include <vector>

#include "tests/exactness/oracle/sweep/sweep_query.h"

namespace platon::oracle {

/// The one right answer to a sweep query.
struct SweepTruth {
  enum class Kind { Miss, Hit, Overlap };

  Kind kind = Kind::Miss;
  /// Time of the hit, numerator / denominator; the denominator is positive. Not reduced.
  Wide numerator = 0;
  Wide denominator = 1;
  /// Outward vectors of every edge of the obstacle that may be named: one, or both where the path enters exactly
  /// through the corner between two edges that it enters.
  std::vector<Vec> normals;
};

/// The forbidden polygon: the convex hull of every difference obstacle point - shape vertex, strictly convex,
/// counter-clockwise.
Polygon forbiddenPolygon(const SweepQuery& query);

/// Answers by building the whole forbidden polygon and walking round it: where the sides on which its vertices lie of
/// the path's line change from left to right, the path enters. Exact: |vertex| < 2^30, so that every product of two
/// cross products stays below 2^126.
SweepTruth sweepTruth(const SweepQuery& query);

/// Checks a truth from the definition alone, in rationals of any size and without a Minkowski sum: the segment is
/// clipped against the shape where it stands at the time in question, and against all that it sweeps over. False when
/// the truth is wrong.
bool confirms(const SweepQuery& query, const SweepTruth& truth);

/// True when an answer is the truth in another dress: fractions equal as rationals, the normal a positive multiple of
/// one of the outward vectors, an overlap exactly `hit 0 1 0 0`.
bool agrees(const SweepTruth& truth, const SweepAnswer& answer);

/// For messages: the truth in the words of the answer format.
std::string toText(const SweepTruth& truth);

}  // namespace platon::oracle
