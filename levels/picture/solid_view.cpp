#include "levels/picture/solid_view.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "levels/drawing/solid_frame.h"

namespace platon {
namespace {

// How a solid stands, on a face or a corner where that looks calm, and where its viewer stands. Degrees.
struct Stance {
  double lean = 0;   // of the front face, backwards
  double right = 0;  // of the viewer, from the middle of the front face
  double above = 0;  // the same, upwards
};

// The viewer stands where no face is seen from the side.
Stance stanceOf(SolidKind kind) {
  switch (kind) {
    case SolidKind::kTetrahedron:
      return {19.4712, 40, 24};
    case SolidKind::kHexahedron:
      return {0, 34, 28};
    case SolidKind::kOctahedron:
      return {35.2644, 34, 16};
    case SolidKind::kDodecahedron:
      return {0, 9, 9};
    default:
      return {-10.8123, 34, 12};
  }
}

glm::dvec2 lowestEdgeNormal(const SolidFrame& solid, glm::dvec2 down) {
  const std::vector<glm::dvec2>& normals = solid.edgeNormals();
  return *std::max_element(normals.begin(), normals.end(),
                           [down](glm::dvec2 a, glm::dvec2 b) { return glm::dot(a, down) < glm::dot(b, down) - 1e-9; });
}

}  // namespace

PlaneMap SolidView::faceMap(const SolidFrame& solid, int face) const {
  const auto seen = [this](glm::dvec3 vector) { return glm::dvec2(glm::dot(vector, right), -glm::dot(vector, up)); };
  const glm::dmat4& toWorld = solid.faceToWorld(face);
  return {seen(glm::dvec3(toWorld[0])), seen(glm::dvec3(toWorld[1])), seen(glm::dvec3(toWorld[3]))};
}

bool SolidView::shows(const SolidFrame& solid, int face) const { return glm::dot(solid.normal(face), towards) > 0; }

double SolidView::brightness(const SolidFrame& solid, int face) const {
  const glm::dvec3 light = glm::normalize(-0.55 * right + 0.75 * up + 0.45 * towards);
  return std::clamp(0.5 + 0.5 * glm::dot(solid.normal(face), light), 0.0, 1.0);
}

SolidView frontView(const SolidFrame& solid, int face, Angle angle) {
  const double radians = toRadians(angle);
  const glm::dvec2 down = lowestEdgeNormal(solid, {std::sin(radians), -std::cos(radians)});
  const glm::dvec3 normal = solid.normal(face);
  const glm::dvec3 upright(solid.faceToWorld(face) * glm::dvec4(-down, 0, 0));
  const glm::dvec3 aside = glm::cross(upright, normal);
  const Stance stance = stanceOf(solid.solid().kind());
  const double lean = glm::radians(stance.lean);
  const double turn = glm::radians(stance.right);
  const double tilt = glm::radians(stance.above);
  const glm::dvec3 axis = std::cos(lean) * upright + std::sin(lean) * normal;
  const glm::dvec3 ahead = std::cos(lean) * normal - std::sin(lean) * upright;
  SolidView view;
  view.towards = std::cos(tilt) * (std::cos(turn) * ahead + std::sin(turn) * aside) + std::sin(tilt) * axis;
  view.right = glm::normalize(glm::cross(axis, view.towards));
  view.up = glm::cross(view.towards, view.right);
  return view;
}

SolidView oppositeOf(const SolidView& view) { return {-view.right, view.up, -view.towards}; }

}  // namespace platon
