#pragma once

#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace platon {

/// Where the border of the screen shows that something lies beyond it.
struct EdgeSign {
  glm::vec2 direction{0};       ///< from the middle of the screen, of length 1, +y down
  glm::vec2 place{0};           ///< on a rectangle around the middle of the screen
  const char* arrow = nullptr;  ///< the arrow that comes nearest to the direction
};

/// The sign of a point that is projected to `clip`; nothing if the picture shows it. `reach`: half the size of the
/// rectangle on which signs stand, at most half of `screen`.
std::optional<EdgeSign> edgeSignOf(glm::dvec4 clip, glm::vec2 screen, glm::vec2 reach);

}  // namespace platon
