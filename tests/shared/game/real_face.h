#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "platon/exact/angle.h"
#include "platon/exact/point.h"
#include "platon/game/solid.h"

namespace platon {

inline constexpr std::array kAllSolids = {SolidKind::kTetrahedron, SolidKind::kHexahedron, SolidKind::kOctahedron,
                                          SolidKind::kDodecahedron, SolidKind::kIcosahedron};

/// A point or vector in subunits, in floating point.
struct Real {
  double x = 0;
  double y = 0;

  friend Real operator+(Real a, Real b) { return {a.x + b.x, a.y + b.y}; }
  friend Real operator-(Real a, Real b) { return {a.x - b.x, a.y - b.y}; }
  friend Real operator*(double factor, Real a) { return {factor * a.x, factor * a.y}; }
};

inline Real real(Point point) { return {static_cast<double>(point.x), static_cast<double>(point.y)}; }
inline double length(Real a) { return std::hypot(a.x, a.y); }
inline double dot(Real a, Real b) { return a.x * b.x + a.y * b.y; }
/// A quarter turn counter-clockwise.
inline Real left(Real a) { return {-a.y, a.x}; }
inline Real turned(Real a, Angle angle) {
  const double radians = angle.centidegrees() * std::numbers::pi / 18000;
  return {a.x * std::cos(radians) - a.y * std::sin(radians), a.x * std::sin(radians) + a.y * std::cos(radians)};
}
inline Point nearest(Real a) {
  return {static_cast<std::int32_t>(std::lround(a.x)), static_cast<std::int32_t>(std::lround(a.y))};
}
/// The angle of a vector from the x axis, rounded to the nearest centidegree.
inline Angle rotationOf(Real a) {
  return Angle(static_cast<std::int32_t>(std::lround(std::atan2(a.y, a.x) / std::numbers::pi * 18000)));
}

/// A face of a solid before its corners are rounded. All faces of a solid are equal.
class RealFace {
 public:
  RealFace(SolidKind kind, std::int32_t faceSize)
      : solid_(PlatonicSolid::of(kind)),
        edge_(1024.0 * faceSize),
        inradius_(edge_ / 2 / std::tan(std::numbers::pi / solid_.edgesPerFace())) {}

  /// The outward unit normal of an edge.
  Real outwards(int edge) const { return turned({0, -1}, Angle(edge * (Angle::kTurn / solid_.edgesPerFace()))); }
  Real middle(int edge) const { return inradius_ * outwards(edge); }
  /// A point of an edge; `along` is 0 at its first corner and 1 at its second.
  Real onEdge(int edge, double along) const { return middle(edge) + (edge_ * (along - 0.5)) * left(outwards(edge)); }
  Real corner(int index) const { return onEdge(index, 0); }
  /// A point in the frame of `face`, transformed to the frame of the face behind `edge`, with both faces in one plane.
  Real over(int face, int edge, Real point) const {
    const PlatonicSolid::Neighbour& behind = solid_.neighbour(face, edge);
    return middle(behind.edge) + turned(point - middle(edge), behind.turn);
  }
  double inradius() const { return inradius_; }

 private:
  const PlatonicSolid& solid_;
  double edge_;
  double inradius_;
};

}  // namespace platon
