#include "levels/drawing/net.h"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace platon {
namespace {

// The joined edges of each solid, in an order in which each face is placed before others hang on it. The first face
// stands upright, except on the tetrahedron, whose base points down. docs/level_format.md draws the nets.
std::vector<Net::Hinge> hingesOf(SolidKind kind) {
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

Net::Net(const SolidFrame& solid)
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
