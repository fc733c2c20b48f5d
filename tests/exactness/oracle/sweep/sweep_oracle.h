#pragma once

#include <string>
#include <vector>

#include "tests/exactness/oracle/sweep/sweep_query.h"

namespace platon::oracle {

/// The correct answer to a sweep query.
struct CorrectAnswer {
  enum class Kind { Miss, Hit, Overlap };

  Kind kind = Kind::Miss;
  /// Time of the hit, numerator / denominator, not reduced. The denominator is positive.
  Wide numerator = 0;
  Wide denominator = 1;
  /// Outward normals that are correct answers: that of the edge entered, or both if the path enters exactly through the
  /// vertex between two edges.
  std::vector<Vec> normals;
};

/// The set of positions at which the shape overlaps the segment, as a strictly convex, counter-clockwise polygon: the
/// convex hull of all differences segment end - shape vertex.
Polygon obstacleOf(const SweepQuery& query);

/// Finds where the path enters the obstacle: at the edge whose ends lie left and right of the path. Exact:
/// |vertex| < 2^30, so every product of two cross products is below 2^126.
CorrectAnswer correctAnswer(const SweepQuery& query);

/// True if `correct` satisfies the definition of a hit. Uses rationals of any size and no Minkowski sum: it clips the
/// segment against the shape at the time of the hit, and against the area that the shape sweeps.
bool confirms(const SweepQuery& query, const CorrectAnswer& correct);

/// True if the answer is correct: the times are equal as rationals, and the normal is a positive multiple of one of the
/// outward normals. An overlap must be exactly `hit 0 1 0 0`.
bool agrees(const CorrectAnswer& correct, const SweepAnswer& answer);

/// The correct answer in the answer format, for messages.
std::string toText(const CorrectAnswer& correct);

}  // namespace platon::oracle
