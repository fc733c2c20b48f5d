#include "client/scene/camera_lead.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace platon {
namespace {

struct Knot {
  double trail = 0;
  double lead = 0;
};

// The lead is linear between the knots, and odd. In a jump the player is at most 50 from the trailing point.
using Knots = std::array<Knot, 4>;
constexpr Knots kRight{{{0, 0}, {30, 0}, {60, 20}, {125, CameraLead::kMaxLead}}};
constexpr Knots kUp{{{0, 0}, {40, -30}, {70, -30}, {160, CameraLead::kMaxLead}}};
constexpr Knots kReducedRight{{{0, 0}, {30, 0}, {60, 0}, {125, 0}}};
constexpr Knots kReducedUp{{{0, 0}, {40, -30}, {70, -30}, {160, -30}}};

// Between two knots the lead is base + slope · trail, the trail falls exponentially, and the differential equation of
// the following point has a closed solution.
double followedLead(const Knots& knots, double trail, double follow, double seconds) {
  const double share = follow / (follow - CameraLead::kTrailRate);
  double size = std::abs(trail);
  double place = 0;
  for (std::size_t i = knots.size() - 1; i > 0; --i) {
    const Knot& low = knots[i - 1];
    if (size <= low.trail) continue;
    const double slope = (knots[i].lead - low.lead) / (knots[i].trail - low.trail);
    const double base = low.lead - slope * low.trail;
    const double toKnot = low.trail > 0 ? std::log(size / low.trail) / CameraLead::kTrailRate : seconds;
    const double time = std::min(seconds, toKnot);
    const double nextSize = size * std::exp(-CameraLead::kTrailRate * time);
    place = (place - base - share * slope * size) * std::exp(-follow * time) + base + share * slope * nextSize;
    size = nextSize;
    seconds -= time;
  }
  return std::copysign(1.0, trail) * place;
}

}  // namespace

void CameraLead::reset(const Pose& player) {
  place_ = player.position;
  trail_ = glm::dvec2(0);
}

void CameraLead::move(const Pose& player) {
  const glm::dvec3 way = player.position - place_;
  trail_ += glm::dvec2(glm::dot(way, glm::cross(player.up, player.normal)), glm::dot(way, player.up));
  const glm::dvec2 longest(kRight.back().trail, kUp.back().trail);
  trail_ = glm::clamp(trail_, -longest, longest);
  place_ = player.position;
}

void CameraLead::wait(double seconds) { trail_ *= std::exp(-kTrailRate * seconds); }

glm::dvec2 CameraLead::followed(double follow, double seconds, bool reduced) const {
  return {followedLead(reduced ? kReducedRight : kRight, trail_.x, follow, seconds),
          followedLead(reduced ? kReducedUp : kUp, trail_.y, follow, seconds)};
}

}  // namespace platon
