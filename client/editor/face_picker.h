#pragma once

#include <optional>

#include <glm/vec2.hpp>

#include "client/editor/face_place.h"
#include "client/scene/camera.h"
#include "client/scene/solid_mesh.h"

namespace platon {

/// The place of the solid that is drawn at a place of the virtual screen (see Overlay: 720 high, +y down). Nothing
/// beside the solid.
std::optional<FacePlace> pickFace(const SolidMesh& mesh, const Camera& camera, glm::dvec2 screen);

/// Length of a level unit at the place, in units of the virtual screen.
double screenScale(const SolidMesh& mesh, const Camera& camera, const FacePlace& at);

}  // namespace platon
