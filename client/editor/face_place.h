#pragma once

#include <glm/vec2.hpp>

namespace platon {

/// A place on a face: level units in the frame of the face.
struct FacePlace {
  int face = 0;
  glm::dvec2 place{0};

  friend bool operator==(const FacePlace&, const FacePlace&) = default;
};

}  // namespace platon
