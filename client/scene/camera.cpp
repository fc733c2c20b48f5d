#include "client/scene/camera.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "client/scene/camera_target.h"
#include "client/scene/view_point.h"

namespace platon {
namespace {

constexpr double kMaxLag = 0.6;     // radians between the line of sight and its target
constexpr double kMaxSlant = 1.25;  // radians between the line of sight and the normal of the player's face
constexpr double kNearest = 0.75;   // of the distance from the player, in target distances: what is nearer, jumps
// Of half a view. With the shift of the framing, both together are less than kMiddle.
constexpr glm::dvec2 kMaxLookAhead(0.24, 0.18);
constexpr double kCutAngle = 1.6;   // radians from the target from which the camera jumps there
constexpr double kLeanRate = 3;     // of the approach to level floors where the player rests, per second
constexpr double kLeanPart = 0.3;   // of the largest roll
constexpr double kCutOffset = 1.0;  // distance of the player from the middle, in half views, from which it jumps

// The smallest rotation from one unit vector to another; about `axis` if they are opposite.
glm::dquat rotationBetween(glm::dvec3 from, glm::dvec3 to, glm::dvec3 axis) {
  const double cosine = glm::dot(from, to);
  if (cosine < -1 + 1e-12) return glm::angleAxis(std::acos(-1.0), axis);
  const glm::dvec3 normal = glm::cross(from, to);
  return glm::normalize(glm::dquat(1 + cosine, normal.x, normal.y, normal.z));
}

double angleBetween(glm::dvec3 a, glm::dvec3 b) { return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)); }

// The angle from the roll of one target to that of another with the same line of sight.
double rollBetween(const CameraTarget& from, const CameraTarget& to) {
  return angleAbout(from.back(), from.orientation * glm::dvec3(1, 0, 0), to.orientation * glm::dvec3(1, 0, 0));
}

glm::dvec2 shortened(glm::dvec2 vector, double longest) {
  const double length = glm::length(vector);
  return length > longest ? vector * (longest / length) : vector;
}

}  // namespace

void Camera::set(const Pose& player, const SolidMesh& stage, std::uint32_t w, std::uint32_t h) {
  resize(w, h);
  hold_.reset();
  lookAhead_.reset(player);
  radius_ = stage.circumradius();
  const CameraTarget moving = cameraTarget(player, stage, zoom_, {peek_});
  const CameraTarget target = levelled(moving, player, stage);
  lean_ = rollBetween(moving, target);
  const bool stands = comfort_.view != CameraView::kFollow;
  base_ = stands ? hold_.view(player, stage, zoom_)
                 : ViewPoint{target.orientation,
                             player.position + target.orientation * framedOffset(target, player.position, stage)};
  shown_ = base_;
}

void Camera::place(glm::dvec3 eye, glm::dvec3 up, const SolidMesh& stage) {
  const glm::dvec3 back = glm::normalize(eye);
  base_ = shown_ = {levelOrientation(back, glm::cross(up, back)), eye};
  lean_ = 0;
  radius_ = stage.circumradius();
}

// Turns and offsets all approach their targets independently of each other, so the result does not depend on the frame
// rate.
void Camera::lerp(const Pose& player, const SolidMesh& stage, double seconds) {
  if (comfort_.view != CameraView::kFollow) {
    lookAhead_.reset(player);
    base_ = shown_ = hold_.view(player, stage, zoom_);
    return;
  }
  const bool rests = lookAhead_.isAt(player);
  lookAhead_.move(player);
  const CameraTarget moving = cameraTarget(player, stage, zoom_, {peek_, rests ? 0 : lookAhead_.rise()});
  const CameraTarget level = levelled(moving, player, stage);
  const CameraTarget& target = rests ? level : moving;
  if (comfort_.instantCut || !isNear(player, target)) return set(player, stage, width_, height_);
  const glm::dvec3 offset = offsetAfter(player, target, framedOffset(target, player.position, stage), seconds);
  lookAhead_.wait(seconds);
  base_.orientation = glm::angleAxis(-lean_, base_.back()) * base_.orientation;
  turn(player, moving, seconds);
  lean((rests ? 1 : moving.level) * rollBetween(moving, level), seconds);
  base_.orientation = glm::normalize(glm::angleAxis(lean_, base_.back()) * base_.orientation);
  base_.eye = player.position + base_.orientation * offset;
  shown_ = base_;
  radius_ = stage.circumradius();
}

bool Camera::isNear(const Pose& player, const CameraTarget& target) const {
  const glm::dvec2 offset(glm::conjugate(base_.orientation) * (base_.eye - player.position));
  return angleBetween(base_.back(), target.back()) < kCutAngle && glm::length(offset) < kCutOffset * target.halfView();
}

// The rotation to the target is split into a swing of the line of sight, which keeps the player visible, and a roll
// about it, which may be slow.
void Camera::turn(const Pose& player, const CameraTarget& target, double seconds) {
  const glm::dvec3 targetBack = target.back();
  const glm::dvec3 back = base_.back();
  const glm::dquat swing = rotationBetween(back, targetBack, base_.up());
  const double roll = angleAbout(targetBack, swing * base_.right(), target.orientation * glm::dvec3(1, 0, 0));
  const double angle = angleBetween(back, targetBack);
  const double longest = std::clamp(kMaxSlant - angleBetween(targetBack, player.normal), 0.0, kMaxLag);
  const double maxSwing = comfort_.reducedMotion ? kSlowSwing : kMaxSwing;
  const double left = leftAfter(std::min(angle, longest), kFollowSpeed, maxSwing, seconds);
  if (angle > 0) base_.orientation = partOf(swing, 1 - left / angle) * base_.orientation;
  const double rollLeft = leftAfter(std::abs(roll), comfort_.turnRate, (1 - kLeanPart) * maxRoll(), seconds);
  const double rolled = std::copysign(std::abs(roll) - rollLeft, roll);
  base_.orientation = glm::angleAxis(rolled, base_.back()) * base_.orientation;
}

// The roll of a player who moves and the lean of one who rests are independent of each other, too. The lean is slow,
// so that the picture does not jerk where the player stops or starts near an edge.
void Camera::lean(double wanted, double seconds) {
  const double missing = wanted - lean_;
  const double left =
      leftAfter(std::abs(missing), std::min(kLeanRate, comfort_.turnRate), kLeanPart * maxRoll(), seconds);
  lean_ = wanted - std::copysign(left, missing);
}

double Camera::maxRoll() const { return comfort_.reducedMotion ? kSlowRoll : comfort_.maxRoll(); }

// From the player to the eye, in the axes of the camera, `seconds` after now. `still` is where it would be if the
// player had not moved.
glm::dvec3 Camera::offsetAfter(const Pose& player, const CameraTarget& target, glm::dvec3 still, double seconds) const {
  const double halfView = target.halfView();
  const glm::dvec3 now = glm::conjugate(base_.orientation) * (base_.eye - player.position);
  const glm::dvec3 start(shortened(now, kMiddle * halfView), std::max(now.z, kNearest * target.distance));
  const glm::dquat toScreen = glm::conjugate(target.orientation);
  const glm::dvec2 scale = glm::min(glm::dvec2(1), kMaxLookAhead * halfView / LookAhead::kMax);
  const glm::dvec2 lookAhead = scale * lookAhead_.followed(kFollowSpeed, seconds, comfort_.reducedMotion);
  const glm::dvec3 leading = lookAhead.x * glm::cross(player.up, player.normal) + lookAhead.y * player.up;
  const double stay = std::exp(-kFollowSpeed * seconds);
  return still * (1 - stay) + start * stay + glm::dvec3(glm::dvec2(toScreen * leading), 0);
}

void Camera::resize(std::uint32_t w, std::uint32_t h) {
  width_ = std::max(w, 1U);
  height_ = std::max(h, 1U);
}

glm::dmat4 Camera::view() const {
  return glm::mat4_cast(glm::conjugate(shown_.orientation)) * glm::translate(glm::dmat4(1), -shown_.eye);
}

glm::dmat4 Camera::viewProjection() const {
  const double aspect = double{1} * width_ / height_;
  const double vertical = 2 * std::atan(CameraTarget::kTangent / std::min(aspect, 1.0));
  const double fromCentre = glm::dot(eye(), back());
  const double radius = std::max(radius_, reach_);
  const double farthest = fromCentre + radius;
  const double nearest = std::max((fromCentre - radius) / 2, farthest / 20000);
  const glm::dmat4 shifted = glm::translate(glm::dmat4(1), glm::dvec3(shift_, 0));
  return shifted * glm::perspective(vertical, aspect, nearest, farthest) * view();
}

double rollIn(const ViewPoint& view, const Pose& player) {
  const glm::dvec3 playerRight = glm::cross(player.up, player.normal);
  const glm::dvec3 back = view.back();
  const glm::dvec3 seen = playerRight - back * glm::dot(playerRight, back);
  return glm::length(seen) < 1e-9 ? 0 : angleAbout(back, view.right(), seen);
}

}  // namespace platon
