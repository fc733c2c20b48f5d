#include "client/scene/face_hold.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "client/scene/camera_target.h"

namespace platon {
namespace {

constexpr double kWholeFace = 1.13;    // shorter side of the picture in diameters of the face
constexpr double kMinWholeView = 460;  // level units
constexpr double kMaxWholeView = 1000;
constexpr double kBorder = 0.7;   // half the part of the picture in which the player stays
constexpr double kTurned = 0.02;  // radians by which the player may turn on the screen

}  // namespace

ViewPoint FaceHold::view(const Pose& player, const SolidMesh& mesh, double zoom) {
  if (view_ && holds(player, zoom)) return *view_;
  const double whole = std::max(kMinWholeView, kWholeFace * 2 * glm::length(mesh.polygon()[0]));
  whole_ = whole <= kMaxWholeView && zoom <= 1;
  normal_ = player.normal;
  zoom_ = zoom;
  centre_ = whole_ ? mesh.inradius() * normal_ : player.position;
  distance_ = whole_ ? whole / zoom / 2 / CameraTarget::kTangent : cameraTarget(player, mesh, zoom).distance;
  view_ = {levelOrientation(normal_, glm::cross(player.up, normal_)), centre_ + distance_ * normal_};
  return *view_;
}

bool FaceHold::holds(const Pose& player, double zoom) const {
  if (zoom != zoom_ || glm::dot(player.normal, normal_) < 1 - 1e-9) return false;
  const glm::dvec3 right = glm::conjugate(view_->orientation) * glm::cross(player.up, player.normal);
  if (std::abs(std::atan2(right.y, right.x)) > kTurned) return false;
  const glm::dvec3 offset = glm::abs(glm::conjugate(view_->orientation) * (player.position - centre_));
  return whole_ || std::max(offset.x, offset.y) < kBorder * CameraTarget::kTangent * distance_;
}

}  // namespace platon
