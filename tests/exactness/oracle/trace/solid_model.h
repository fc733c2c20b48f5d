#pragma once

#include <cstdint>
#include <string_view>

#include "tests/exactness/oracle/exact_geometry.h"

namespace platon::oracle {

/// Hundredths of a degree in a turn.
inline constexpr std::int64_t kTurn = 36000;

/// An angle without its whole turns, in [0, 36000).
std::int64_t withoutTurns(std::int64_t centidegrees);

/// A Platonic solid by its numbers: faces, corners of a face, faces round a corner.
struct SolidNumbers {
  std::string_view name;
  std::size_t faces = 0;
  std::size_t corners = 0;
  std::size_t degree = 0;
};

/// Nothing for a name that is none of the five.
const SolidNumbers* findSolid(std::string_view name);

/// A point of the real plane, in subunits. Good to about 1e-9 for all that a face can hold: enough to judge tolerances
/// of whole subunits.
struct RealVec {
  long double x = 0;
  long double y = 0;
};

RealVec toReal(Vec v);
long double distance(RealVec a, RealVec b);

/// The corner of the ideal regular face: centre at the origin, edge 0 (corner 0 to 1) at the bottom, counter-clockwise.
RealVec idealCorner(std::size_t corners, long double edgeLength, std::size_t index);

/// The middle of the ideal edge from corner `index` to the next.
RealVec idealEdgeMiddle(std::size_t corners, long double edgeLength, std::size_t index);

/// A real motion of the plane: turn about the origin, then shift.
class Isometry {
 public:
  Isometry() = default;
  /// Turns by exactly this angle and carries `from` to `onto`.
  Isometry(std::int64_t turn, RealVec from, RealVec onto);

  RealVec apply(RealVec point) const;
  /// What becomes of a displacement.
  RealVec turned(RealVec displacement) const;
  std::int64_t turn() const { return turn_; }

 private:
  std::int64_t turn_ = 0;
  long double cosine_ = 1;
  long double sine_ = 0;
  RealVec shift_;
};

}  // namespace platon::oracle
