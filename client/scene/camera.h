#pragma once

#include <cstdint>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "client/scene/pose.h"
#include "client/scene/solid_mesh.h"

namespace platon {

/// How the camera turns.
struct CameraComfort {
  double turnSpeed = 7;        ///< share of the remaining roll that is made up per second, 1 … 30
  bool instantCut = false;     ///< no swing and no roll: the camera always is where `set` puts it
  bool reducedMotion = false;  ///< rolls by at most kSlowRoll radians a second
};

/// Stands on the ray from the solid's centre through the player and looks at the centre; its up is the player's up.
/// Orientation is a quaternion, from which the place follows.
class Camera {
 public:
  static constexpr double kFollowSpeed = 14;  ///< like turnSpeed, for the place
  static constexpr double kSlowRoll = 0.8;

  /// Places the camera at once, for a picture of w × h pixels, both at least 1.
  void set(const Pose& player, const SolidMesh& stage, std::uint32_t w, std::uint32_t h);
  /// Moves on from the present place to where `set` would put it, as far as it gets in `seconds` ≥ 0. Towards a player
  /// that stands still, two steps come to where one of both times would.
  void lerp(const Pose& player, const SolidMesh& stage, double seconds);

  void resize(std::uint32_t w, std::uint32_t h);
  void setComfort(const CameraComfort& comfort) { comfort_ = comfort; }
  /// How much larger than usual things are drawn, 0.25 … 4; takes effect with the next `set` or `lerp`.
  void setZoom(double zoom) { zoom_ = zoom; }

  glm::dvec3 eye() const { return distance_ * back(); }
  glm::dvec3 right() const { return orientation_ * glm::dvec3(1, 0, 0); }
  glm::dvec3 up() const { return orientation_ * glm::dvec3(0, 1, 0); }
  /// From the solid's centre to the eye, unit.
  glm::dvec3 back() const { return orientation_ * glm::dvec3(0, 0, 1); }

  glm::dmat4 view() const;
  /// From space to OpenGL's clip space.
  glm::dmat4 viewProjection() const;

  /// Radians counter-clockwise from the screen's up to the player's up as seen; 0 after `set`.
  double rollOf(const Pose& player) const;

  std::uint32_t width() const { return width_; }
  std::uint32_t height() const { return height_; }

 private:
  double wantedDistance(const Pose& player, const SolidMesh& stage) const;
  double rolledIn(double roll, double seconds) const;

  glm::dquat orientation_{1, 0, 0, 0};
  double distance_ = 1000;
  double radius_ = 500;  // of the solid, for the depth range
  double zoom_ = 1;
  CameraComfort comfort_;
  std::uint32_t width_ = 1;
  std::uint32_t height_ = 1;
};

}  // namespace platon
