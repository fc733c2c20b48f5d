#pragma once

#include <cstdint>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "client/scene/camera_comfort.h"
#include "client/scene/pose.h"
#include "client/scene/solid_mesh.h"

namespace platon {

/// The camera stands on the ray from the solid's centre through the player and looks at the centre. Its up is the
/// player's up. Its position follows from its orientation and its distance from the centre.
class Camera {
 public:
  static constexpr double kFollowSpeed = 14;  ///< rate of the approach to the player's position, per second
  static constexpr double kSlowRoll = 0.8;    ///< largest roll with reduced motion, radians a second

  /// Moves the camera to its target at once. The picture has w × h pixels, both at least 1.
  void set(const Pose& player, const SolidMesh& stage, std::uint32_t w, std::uint32_t h);
  /// Puts the camera at `eye`, which is not the centre of the solid, with `up` up. The size of the picture stays.
  void place(glm::dvec3 eye, glm::dvec3 up, const SolidMesh& stage);
  /// Moves the camera towards the target of `set` for `seconds` ≥ 0. While the player stands still, two calls have the
  /// effect of one call with the sum of their times.
  void lerp(const Pose& player, const SolidMesh& stage, double seconds);

  void resize(std::uint32_t w, std::uint32_t h);
  void setComfort(const CameraComfort& comfort) { comfort_ = comfort; }
  /// Magnification, 0.25 … 4. Takes effect at the next `set` or `lerp`.
  void setZoom(double zoom) { zoom_ = zoom; }

  glm::dvec3 eye() const { return distance_ * back(); }
  glm::dvec3 right() const { return orientation_ * glm::dvec3(1, 0, 0); }
  glm::dvec3 up() const { return orientation_ * glm::dvec3(0, 1, 0); }
  /// Unit vector from the solid's centre to the eye.
  glm::dvec3 back() const { return orientation_ * glm::dvec3(0, 0, 1); }

  glm::dmat4 view() const;
  /// Transforms from space to OpenGL's clip space.
  glm::dmat4 viewProjection() const;

  /// Angle from the screen's up to the player's up on the screen, radians counter-clockwise; 0 after `set`.
  double rollOf(const Pose& player) const;

  std::uint32_t width() const { return width_; }
  std::uint32_t height() const { return height_; }

 private:
  double targetDistance(const Pose& player, const SolidMesh& stage) const;
  double rollDuring(double roll, double seconds) const;

  glm::dquat orientation_{1, 0, 0, 0};
  double distance_ = 1000;
  double radius_ = 500;  // circumradius of the solid, for the depth range
  double zoom_ = 1;
  CameraComfort comfort_;
  std::uint32_t width_ = 1;
  std::uint32_t height_ = 1;
};

}  // namespace platon
