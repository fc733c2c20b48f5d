#pragma once

#include <cstdint>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "client/scene/camera_controls.h"
#include "client/scene/camera_target.h"
#include "client/scene/solid_mesh.h"
#include "client/scene/view_point.h"

namespace platon {

/// Angle from the right of a view to that of the player, seen along its line of sight, radians counter-clockwise.
double rollIn(const ViewPoint& view, const Pose& player);

/// The camera stands above the player, whose right is level on the screen, and looks nearly along the normal of the
/// face (cameraTarget); near an edge it turns to the next face. Where the player stops, floors become level. It follows
/// the player with a delay, and leads a player who runs on; the middle of the picture is a little nearer to the centre
/// of the solid. The player is always in the middle part of the picture, and never hidden by the solid: where the
/// player is too far from there, as after a return to the start, the camera jumps. With CameraView::kFace and kFaceFade
/// it stands still on each face.
class Camera {
 public:
  static constexpr double kFollowSpeed = 14;  ///< rate of the approach to the player's position, per second
  static constexpr double kMaxSwing = 9;      ///< largest turn of the line of sight, radians a second
  static constexpr double kSlowSwing = 2.5;   ///< the same with reduced motion, unless the player would be hidden
  static constexpr double kSlowRoll = 0.8;    ///< largest roll with reduced motion, radians a second
  static constexpr double kMiddle = 0.6;      ///< the player's distance from the middle, in half shorter sides

  /// Moves the camera to its target at once. The picture has w × h pixels, both at least 1.
  void set(const Pose& player, const SolidMesh& stage, std::uint32_t w, std::uint32_t h);
  /// Puts the camera at `eye`, which is not the centre of the solid, with `up` up, so that it looks at the centre. The
  /// size of the picture stays.
  void place(glm::dvec3 eye, glm::dvec3 up, const SolidMesh& stage);
  /// Moves the camera towards the target of `set` for `seconds` ≥ 0. While the player stands still, two calls have the
  /// effect of one call with the sum of their times. The roll is at most CameraComfort::maxRoll.
  void lerp(const Pose& player, const SolidMesh& stage, double seconds);

  /// What `set`, `place` and `lerp` have made of the view.
  const ViewPoint& viewPoint() const { return base_; }
  /// What the pictures show.
  const ViewPoint& shownView() const { return shown_; }
  /// The next `lerp` begins at this view.
  void goOnFrom(const ViewPoint& view) { base_ = shown_ = view; }
  /// Shows another view, which does not affect the next `lerp`, until the next `set`, `place` or `lerp`.
  void show(const ViewPoint& view) { shown_ = view; }

  void resize(std::uint32_t w, std::uint32_t h);
  void setComfort(const CameraComfort& comfort) { comfort_ = comfort; }
  /// Magnification, 0.25 … 4. Takes effect at the next `set` or `lerp`.
  void setZoom(double zoom) { zoom_ = zoom; }

  /// How far the view may turn to each face near an edge: see PeekWeights. Takes effect at the next `set` or `lerp`.
  void setPeek(PeekWeights weights) { peek_.assign(weights.begin(), weights.end()); }

  /// Shows the middle of the view this far to the right of the middle of the picture and above it, in half widths and
  /// half heights of it.
  void setShift(glm::dvec2 shift) { shift_ = shift; }

  /// The pictures show what is within this distance from the centre of the solid, level units, and all of the solid.
  void setReach(double reach) { reach_ = reach; }

  glm::dvec3 eye() const { return shown_.eye; }
  glm::dvec3 right() const { return shown_.orientation * glm::dvec3(1, 0, 0); }
  glm::dvec3 up() const { return shown_.orientation * glm::dvec3(0, 1, 0); }
  /// Unit vector against the line of sight.
  glm::dvec3 back() const { return shown_.orientation * glm::dvec3(0, 0, 1); }

  glm::dmat4 view() const;
  /// Transforms from space to OpenGL's clip space.
  glm::dmat4 viewProjection() const;

  /// `rollIn` of the view; after `set` in the middle part of a face at most 0.01. `show` does not affect it.
  double rollOf(const Pose& player) const { return rollIn(base_, player); }

  std::uint32_t width() const { return width_; }
  std::uint32_t height() const { return height_; }

 private:
  bool isNear(const Pose& player, const CameraTarget& target) const;
  double maxRoll() const;
  void lean(double wanted, double seconds);
  void turn(const Pose& player, const CameraTarget& target, double seconds);
  glm::dvec3 offsetAfter(const Pose& player, const CameraTarget& target, glm::dvec3 still, double seconds) const;

  ViewPoint base_;
  ViewPoint shown_;
  LookAhead lookAhead_;
  FaceHold hold_;
  double lean_ = 0;      // of base_ for level floors at rest, radians counter-clockwise
  double radius_ = 500;  // circumradius of the solid, for the depth range
  double reach_ = 0;
  double zoom_ = 1;
  glm::dvec2 shift_{0};
  CameraComfort comfort_;
  std::vector<double> peek_;
  std::uint32_t width_ = 1;
  std::uint32_t height_ = 1;
};

}  // namespace platon
