#pragma once

#include <optional>
#include <span>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "client/scene/solid_mesh.h"
#include "client/scene/view_point.h"

namespace platon {

/// How the camera would look at a player.
struct CameraTarget {
  static constexpr double kEdgeZone = 60;  ///< level units from an edge within which the view turns to the next face
  static constexpr double kTangent = 0.2;  ///< of half the smaller field of view, which is 23 degrees
  static constexpr double kWholeSolid = 1.1 / kTangent;  ///< circumradii: distance from the centre at which all is seen

  glm::dquat orientation{1, 0, 0, 0};  ///< of the axes right, up, back
  double distance = 1000;              ///< from the player to the eye along back, level units
  double level = 0;  ///< part of the way to `levelled` while the player moves: 0 near an edge, 1 in the middle part

  glm::dvec3 back() const { return orientation * glm::dvec3(0, 0, 1); }
  /// Half the shorter side of the picture at the player, level units.
  double halfView() const { return kTangent * distance; }
};

/// The orientation whose z axis is the unit vector `back` and whose x axis is nearest to `right`.
glm::dquat levelOrientation(glm::dvec3 back, glm::dvec3 right);

/// Angle about `axis` between two vectors perpendicular to it, radians counter-clockwise.
double angleAbout(glm::dvec3 axis, glm::dvec3 from, glm::dvec3 to);

/// By face: how far the view may turn to it near an edge, 0 … 1. Empty: 1 for all.
using PeekWeights = std::span<const double>;

/// How the view of a moving player turns near edges.
struct Peek {
  PeekWeights weights = {};
  double rise = 0;  ///< level units along the player's up that are not seen yet, as of a jump; of a fall none
};

/// The normal of the solid with its edges rounded off: the normal of the face in the middle part of a face, the mean
/// of the normals of the faces that meet at an edge or at a corner, and continuous between. On a small face the zone
/// at the edges is narrower. `place` is on the surface.
glm::dvec3 roundedNormal(const SolidMesh& mesh, glm::dvec3 place, PeekWeights weights = {});

/// Of a player who moves. The line of sight is nearly the rounded normal, with a part of the ray from the solid's
/// centre (kPartOfRay), so that the neighbouring faces are seen. The player's right is nearly level on the screen in
/// the middle part of a face. Near edges and corners the picture turns evenly with the way, the same whichever way the
/// player's up points: on a way round a corner, it rolls once. `zoom` is a magnification, more than 0.
CameraTarget cameraTarget(const Pose& player, const SolidMesh& mesh, double zoom, const Peek& peek = {});
constexpr double kMaxFramingShift = 0.5;  ///< in half shorter sides of the picture

/// How far the middle of the picture is from a player who stands still at `place`, along the axes of the target, in
/// level units. It lies towards the solid's centre, so that the picture shows more of the solid; on a face that is much
/// larger than the picture, less.
glm::dvec2 framingShift(const CameraTarget& target, glm::dvec3 place, const SolidMesh& mesh);
/// From a player who stands still to the eye, in the axes of the target.
glm::dvec3 framedOffset(const CameraTarget& target, glm::dvec3 place, const SolidMesh& mesh);

/// Of a player who rests: the line of sight of `target`, but a floor along the player's right is level in the picture,
/// wherever the player is.
CameraTarget levelled(CameraTarget target, const Pose& player, const SolidMesh& mesh);

/// How far the middle of the picture leads the player, from the way that the player has gone lately. A point trails the
/// player; the look-ahead is a function of the distance to it. Small turns and jumps keep that distance small. Against
/// a jump, the look-ahead is negative: the picture rises less than the player.
class LookAhead {
 public:
  static constexpr double kTrailRate = 1.5;  ///< rate of the approach of the trailing point to the player, per second
  static constexpr double kMax = 65;         ///< level units, in each direction

  /// The player stands still.
  void reset(const Pose& player);
  /// The player has moved here.
  void move(const Pose& player);
  /// Whether the player is where it was last.
  bool isAt(const Pose& player) const { return player.position == place_; }
  /// How far the player is above the trailing point, level units.
  double rise() const { return trail_.y; }
  /// The trailing point approaches the player for `seconds` ≥ 0.
  void wait(double seconds);

  /// Where a point is after `seconds` ≥ 0 that starts at the player, who stands still, and approaches the look-ahead at
  /// the rate `follow`, which is not kTrailRate: to the player's right and along its up, level units. With `reduced`
  /// nothing leads the player.
  glm::dvec2 followed(double follow, double seconds, bool reduced) const;

 private:
  glm::dvec3 place_{0};  // of the player
  glm::dvec2 trail_{0};  // from the trailing point to the player: to the player's right and along its up
};

/// The view of a camera that stands still. It shows the whole face of the player; of a large face it shows a part, and
/// another one when the player comes near the border of the picture.
class FaceHold {
 public:
  /// The view of the player, which is the last one as long as the face, the player's up and the zoom stay the same and
  /// the player stays away from the border of the picture. `zoom` is a magnification, more than 0.
  ViewPoint view(const Pose& player, const SolidMesh& mesh, double zoom);
  /// The next view does not depend on the last one.
  void reset() { view_.reset(); }

 private:
  bool holds(const Pose& player, double zoom) const;

  std::optional<ViewPoint> view_;
  glm::dvec3 centre_{0};  // of the picture, on the face
  glm::dvec3 normal_{0};
  double distance_ = 0;  // of the eye from the face
  double zoom_ = 1;
  bool whole_ = false;  // the view shows the whole face
};

}  // namespace platon
