#include "client/hud/edge_sign.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <glm/geometric.hpp>

namespace platon {
namespace {

// Counter-clockwise from the right, each for an eighth of a turn around it.
constexpr std::array<const char*, 8> kArrows{"→", "↗", "↑", "↖", "←", "↙", "↓", "↘"};

const char* arrowOf(glm::dvec2 direction) {
  const double eighths = std::atan2(-direction.y, direction.x) * 4 / std::numbers::pi;
  return kArrows[static_cast<std::size_t>(std::lround(eighths) + 8) % kArrows.size()];
}

}  // namespace

std::optional<EdgeSign> edgeSignOf(glm::dvec4 clip, glm::vec2 screen, glm::vec2 reach) {
  const bool before = clip.w > 0;
  if (before && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w) return std::nullopt;
  // What is behind the camera is projected to the opposite side.
  const double side = before ? 1 : -1;
  glm::dvec2 way(side * clip.x * screen.x, -side * clip.y * screen.y);
  if (glm::length(way) < 1e-9) way = {0, 1};
  const glm::dvec2 direction = glm::normalize(way);
  const double toSide = reach.x / std::max(std::abs(direction.x), 1e-9);
  const double toTop = reach.y / std::max(std::abs(direction.y), 1e-9);
  const glm::vec2 place = screen / 2.0F + glm::vec2(direction * std::min(toSide, toTop));
  return EdgeSign{glm::vec2(direction), place, arrowOf(direction)};
}

}  // namespace platon
