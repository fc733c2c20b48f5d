#include "client/scene/camera_framing.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace platon {
namespace {

constexpr double kPart = 0.85;  // of the way to the centre, up to the largest shift

}  // namespace

// What is across the line of sight has no jump at an edge, as the line of sight has none.
glm::dvec2 framingShift(const CameraTarget& target, glm::dvec3 place, const SolidMesh& mesh) {
  const glm::dvec2 wanted = -kPart * glm::dvec2(glm::conjugate(target.orientation) * place);
  const double halfView = target.halfView();
  const double longest = kMaxFramingShift * halfView * std::min(1.0, halfView / mesh.apothem());
  const double length = glm::length(wanted);
  return length > longest ? wanted * (longest / length) : wanted;
}

}  // namespace platon
