#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include <glm/vec2.hpp>

#include "client/editor/edited_segment.h"
#include "client/scene/camera.h"
#include "client/scene/solid_mesh.h"

namespace platon {

/// The place of the solid that is drawn at a place of the virtual screen (see Overlay: 720 high, +y down). Nothing
/// beside the solid.
std::optional<FacePlace> pickFace(const SolidMesh& mesh, const Camera& camera, glm::dvec2 screen);

/// Length of a level unit at the place, in units of the virtual screen.
double screenScale(const SolidMesh& mesh, const Camera& camera, const FacePlace& at);

/// Degrees from the face's +y to the up of the picture.
double upOfPicture(const SolidMesh& mesh, int face, const Camera& camera);

/// A segment near a pointer, and what of it.
struct PickedSegment {
  enum class Part { kWhole, kFirstEnd, kSecondEnd };

  std::size_t segment = 0;  ///< index into the segments
  Part part = Part::kWhole;

  friend bool operator==(const PickedSegment&, const PickedSegment&) = default;
};

/// The segment of the pointer's face that is nearest to the pointer, within `reach` level units; of equally near ones
/// the last. An outer third of a segment stands for its end.
std::optional<PickedSegment> pickSegment(std::span<const EditedSegment> segments, const FacePlace& pointer,
                                         double reach);

}  // namespace platon
