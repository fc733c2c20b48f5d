#pragma once

#include <memory>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace platon {

/// A stroke on a face that belongs to no level, such as a segment while it is drawn. With equal ends, a dot.
struct FaceMark {
  int face = 0;
  glm::vec2 a{0};  ///< level units in the frame of the face
  glm::vec2 b{0};
  float width = 4;      ///< level units
  glm::vec4 colour{1};  ///< with opacity
};

/// Marks that are drawn together. A list is never changed, so that a painter can keep it.
using FaceMarks = std::shared_ptr<const std::vector<FaceMark>>;

}  // namespace platon
