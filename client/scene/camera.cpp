#include "client/scene/camera.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace platon {
namespace {

constexpr double kTangent = 0.365;  // tangent of half the smaller field of view: 40 degrees
constexpr double kMinView = 460;    // shorter side of the picture at the player, level units
constexpr double kMaxView = 760;
constexpr double kViewOfFace = 1.3;  // the same in incircle diameters of a face, between the two bounds

// The orientation whose z axis is `back` and whose y axis is nearest to `up`.
glm::dquat orientationOf(glm::dvec3 back, glm::dvec3 up) {
  glm::dvec3 right = glm::cross(up, back);
  // If `up` is parallel to `back`, any perpendicular direction is used.
  if (glm::length(right) < 1e-9) right = glm::cross(glm::dvec3(back.y, back.z, back.x) + glm::dvec3(0.5, 0, 0), back);
  right = glm::normalize(right);
  return glm::normalize(glm::quat_cast(glm::dmat3(right, glm::cross(back, right), back)));
}

// The smallest rotation from one unit vector to another; about `axis` if they are opposite.
glm::dquat rotationBetween(glm::dvec3 from, glm::dvec3 to, glm::dvec3 axis) {
  const double cosine = glm::dot(from, to);
  if (cosine < -1 + 1e-12) return glm::angleAxis(std::acos(-1.0), axis);
  const glm::dvec3 normal = glm::cross(from, to);
  return glm::normalize(glm::dquat(1 + cosine, normal.x, normal.y, normal.z));
}

// Angle about `axis` between two vectors perpendicular to it, radians counter-clockwise.
double angleAbout(glm::dvec3 axis, glm::dvec3 from, glm::dvec3 to) {
  return std::atan2(glm::dot(axis, glm::cross(from, to)), glm::dot(from, to));
}

glm::dquat partOf(glm::dquat turn, double part) { return glm::slerp(glm::dquat(1, 0, 0, 0), turn, part); }

// Part of the remaining distance covered in `seconds` by an exponential approach with this rate.
double partIn(double rate, double seconds) { return -std::expm1(-rate * seconds); }

}  // namespace

void Camera::set(const Pose& player, const SolidMesh& stage, std::uint32_t w, std::uint32_t h) {
  resize(w, h);
  orientation_ = orientationOf(glm::normalize(player.position), player.up);
  distance_ = targetDistance(player, stage);
  radius_ = stage.circumradius();
}

void Camera::place(glm::dvec3 eye, glm::dvec3 up, const SolidMesh& stage) {
  orientation_ = orientationOf(glm::normalize(eye), up);
  distance_ = glm::length(eye);
  radius_ = stage.circumradius();
}

// The rotation to the target is split into a swing of the line of sight, which keeps the player visible, and a roll
// about it, which may be slow. Both decay exponentially, so the result does not depend on the frame rate.
void Camera::lerp(const Pose& player, const SolidMesh& stage, double seconds) {
  if (comfort_.instantCut) return set(player, stage, width_, height_);
  const glm::dquat target = orientationOf(glm::normalize(player.position), player.up);
  const glm::dvec3 targetBack = target * glm::dvec3(0, 0, 1);
  const glm::dquat swing = rotationBetween(back(), targetBack, up());
  const double roll = angleAbout(targetBack, swing * up(), target * glm::dvec3(0, 1, 0));
  const double follow = partIn(kFollowSpeed, seconds);
  orientation_ = partOf(swing, follow) * orientation_;
  orientation_ = glm::normalize(glm::angleAxis(rollDuring(roll, seconds), back()) * orientation_);
  distance_ += (targetDistance(player, stage) - distance_) * follow;
  radius_ = stage.circumradius();
}

void Camera::resize(std::uint32_t w, std::uint32_t h) {
  width_ = std::max(w, 1U);
  height_ = std::max(h, 1U);
}

glm::dmat4 Camera::view() const {
  return glm::translate(glm::dmat4(1), glm::dvec3(0, 0, -distance_)) * glm::mat4_cast(glm::conjugate(orientation_));
}

glm::dmat4 Camera::viewProjection() const {
  const double aspect = double{1} * width_ / height_;
  const double vertical = 2 * std::atan(kTangent / std::min(aspect, 1.0));
  const double farthest = distance_ + radius_;
  const double nearest = std::max((distance_ - radius_) / 2, farthest / 20000);
  return glm::perspective(vertical, aspect, nearest, farthest) * view();
}

double Camera::rollOf(const Pose& player) const {
  const glm::dvec3 seen = player.up - back() * glm::dot(player.up, back());
  return glm::length(seen) < 1e-9 ? 0 : angleAbout(back(), up(), seen);
}

double Camera::targetDistance(const Pose& player, const SolidMesh& stage) const {
  const double view = std::clamp(2 * stage.apothem() * kViewOfFace, kMinView, kMaxView) / zoom_;
  return glm::length(player.position) + view / 2 / kTangent;
}

double Camera::rollDuring(double roll, double seconds) const {
  const double eased = roll * partIn(comfort_.turnSpeed, seconds);
  const double maxRoll = comfort_.reducedMotion ? kSlowRoll * seconds : std::abs(eased);
  return std::clamp(eased, -maxRoll, maxRoll);
}

}  // namespace platon
