#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "client/scene/camera_target.h"
#include "client/scene/solid_mesh.h"

namespace platon {

constexpr double kMaxFramingShift = 0.5;  ///< in half shorter sides of the picture

/// How far the middle of the picture is from a player who stands still at `place`, along the axes of the target, in
/// level units. It lies towards the solid's centre, so that the picture shows more of the solid; on a face that is much
/// larger than the picture, less.
glm::dvec2 framingShift(const CameraTarget& target, glm::dvec3 place, const SolidMesh& mesh);

}  // namespace platon
