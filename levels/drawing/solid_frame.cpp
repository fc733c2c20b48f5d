#include "levels/drawing/solid_frame.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <queue>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace platon {
namespace {

constexpr double kPi = std::numbers::pi;

int facesPerVertex(SolidKind kind) {
  switch (kind) {
    case SolidKind::kOctahedron:
      return 4;
    case SolidKind::kIcosahedron:
      return 5;
    default:
      return 3;
  }
}

glm::dvec2 unit(double angle) { return {std::cos(angle), std::sin(angle)}; }

}  // namespace

// Formulas of the regular polyhedron {p, q}: p edges per face, q faces per vertex.
SolidFrame::SolidFrame(SolidKind kind, double faceSize) : solid_(&PlatonicSolid::of(kind)), faceSize_(faceSize) {
  const int p = solid_->edgesPerFace();
  const int q = facesPerVertex(kind);
  apothem_ = faceSize / 2 / std::tan(kPi / p);
  dihedral_ = 2 * std::asin(std::cos(kPi / q) / std::sin(kPi / p));
  inradius_ = apothem_ * std::tan(dihedral_ / 2);
  circumradius_ = faceSize / 2 * std::tan(kPi / q) * std::tan(dihedral_ / 2);
  const double cornerRadius = faceSize / 2 / std::sin(kPi / p);
  for (int i = 0; i < p; ++i) {
    const double edgeAngle = -kPi / 2 + 2 * kPi * i / p;
    edgeNormals_.push_back(unit(edgeAngle));
    polygon_.push_back(cornerRadius * unit(edgeAngle - kPi / p));
  }
  placeFaces();
}

glm::dvec3 SolidFrame::toWorld(int face, glm::dvec2 point) const {
  return glm::dvec3(faceToWorld(face) * glm::dvec4(point, 0, 1));
}

glm::dmat4 SolidFrame::unfolded(int face, int edge) const {
  const PlatonicSolid::Neighbour& neighbour = solid_->neighbour(face, edge);
  const glm::dvec3 centre(2 * apothem_ * edgeNormals_[static_cast<std::size_t>(edge)], 0);
  return glm::rotate(glm::translate(glm::dmat4(1), centre), -toRadians(neighbour.turn), glm::dvec3(0, 0, 1));
}

void SolidFrame::placeFaces() {
  faceToWorld_.resize(static_cast<std::size_t>(faces()));
  std::vector<bool> placed(faceToWorld_.size());
  std::queue<int> open;
  faceToWorld_[0] = glm::translate(glm::dmat4(1), glm::dvec3(0, 0, inradius_));
  placed[0] = true;
  for (open.push(0); !open.empty(); open.pop()) {
    const int face = open.front();
    for (int edge = 0; edge < solid_->edgesPerFace(); ++edge) {
      const std::size_t next = solid_->neighbour(face, edge).face;
      if (placed[next]) continue;
      const auto i = static_cast<std::size_t>(edge);
      const glm::dvec3 hinge(apothem_ * edgeNormals_[i], 0);
      const glm::dvec3 along(polygon_[(i + 1) % polygon_.size()] - polygon_[i], 0);
      const glm::dmat4 toHinge = glm::translate(glm::dmat4(1), hinge);
      const glm::dmat4 fold = glm::rotate(toHinge, kPi - dihedral_, glm::normalize(along));
      faceToWorld_[next] = faceToWorld_[static_cast<std::size_t>(face)] * fold * glm::translate(glm::dmat4(1), -hinge) *
                           unfolded(face, edge);
      placed[next] = true;
      open.push(static_cast<int>(next));
    }
  }
}

namespace {

// The joined edges of each solid, in an order in which each face is placed before others hang on it. The first face
// stands upright, except on the tetrahedron, whose base points down. docs/level_format.md draws the unfoldings.
std::vector<Unfolding::Hinge> hingesOf(SolidKind kind) {
  switch (kind) {
    case SolidKind::kTetrahedron:
      return {{3, 0}, {3, 1}, {3, 2}};
    case SolidKind::kHexahedron:
      return {{0, 0}, {0, 1}, {0, 2}, {0, 3}, {1, 1}};
    case SolidKind::kOctahedron:
      return {{0, 0}, {0, 2}, {0, 1}, {1, 1}, {1, 0}, {5, 2}, {6, 2}};
    case SolidKind::kDodecahedron:
      return {{0, 0}, {0, 1}, {0, 2}, {0, 3}, {0, 4}, {5, 3}, {9, 0}, {11, 0}, {11, 1}, {11, 2}, {11, 4}};
    default:
      return {{5, 1},  {10, 2}, {6, 1},  {11, 2}, {7, 1},  {12, 2}, {8, 1},  {13, 2}, {9, 1}, {5, 0},
              {10, 0}, {6, 0},  {11, 0}, {7, 0},  {12, 0}, {8, 0},  {13, 0}, {9, 0},  {14, 0}};
  }
}

}  // namespace

Unfolding::Unfolding(const SolidFrame& solid)
    : hinges_(hingesOf(solid.solid().kind())), faceToPlane_(static_cast<std::size_t>(solid.faces())) {
  const double turn = solid.solid().kind() == SolidKind::kTetrahedron ? glm::pi<double>() : 0;
  const auto first = static_cast<std::size_t>(hinges_.front().face);
  faceToPlane_[first] = glm::rotate(glm::dmat4(1), turn, glm::dvec3(0, 0, 1));
  for (const Hinge& hinge : hinges_) {
    const std::size_t next = solid.solid().neighbour(hinge.face, hinge.edge).face;
    faceToPlane_[next] = faceToPlane_[static_cast<std::size_t>(hinge.face)] * solid.unfolded(hinge.face, hinge.edge);
  }
}

}  // namespace platon
