#pragma once

#include <cstdint>
#include <string_view>

#include "tests/exactness/oracle/exact_geometry.h"

namespace platon::oracle {

/// Centidegrees of a full turn.
inline constexpr std::int64_t kTurn = 36000;

/// The same angle in [0, 36000).
std::int64_t normalizedAngle(std::int64_t centidegrees);

/// The numbers that determine a Platonic solid.
struct SolidNumbers {
  std::string_view name;
  std::size_t faces = 0;
  std::size_t corners = 0;  ///< corners per face
  std::size_t facesPerCorner = 0;
};

/// The solid with this name; nullptr if there is none.
const SolidNumbers* findSolid(std::string_view name);

/// A point or vector of the real plane, in subunits. Accurate to about 1e-9 on every face, which suffices for
/// tolerances of whole subunits.
struct RealVec {
  long double x = 0;
  long double y = 0;
};

RealVec toReal(Vec v);
long double distance(RealVec a, RealVec b);

/// A corner of the ideal regular face. Its centre is the origin, edge 0 (corner 0 to 1) is at the bottom, and corners
/// are numbered counter-clockwise.
RealVec idealCorner(std::size_t corners, long double edgeLength, std::size_t index);

/// The middle of the ideal edge from corner `index` to the next.
RealVec idealEdgeMiddle(std::size_t corners, long double edgeLength, std::size_t index);

/// A motion of the real plane: a rotation about the origin, then a translation.
class Isometry {
 public:
  Isometry() = default;
  /// Rotates by `turn` centidegrees and maps `from` to `onto`.
  Isometry(std::int64_t turn, RealVec from, RealVec onto);

  RealVec apply(RealVec point) const;
  /// The rotation applied to a vector.
  RealVec turned(RealVec displacement) const;
  std::int64_t turn() const { return turn_; }

 private:
  std::int64_t turn_ = 0;
  long double cosine_ = 1;
  long double sine_ = 0;
  RealVec shift_;
};

}  // namespace platon::oracle
