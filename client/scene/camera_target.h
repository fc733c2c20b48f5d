#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "client/scene/pose.h"
#include "client/scene/solid_mesh.h"

namespace platon {

/// How the camera would look at a player that stands still.
struct CameraTarget {
  static constexpr double kEdgeZone = 60;  ///< level units from an edge within which the view turns to the next face
  static constexpr double kTangent = 0.2;  ///< of half the smaller field of view, which is 23 degrees

  glm::dquat orientation{1, 0, 0, 0};  ///< of the axes right, up, back
  double distance = 1000;              ///< from the player to the eye along back, level units

  glm::dvec3 back() const { return orientation * glm::dvec3(0, 0, 1); }
  /// Half the shorter side of the picture at the player, level units.
  double halfView() const { return kTangent * distance; }
};

/// The orientation whose z axis is the unit vector `back` and whose x axis is nearest to `right`.
glm::dquat levelOrientation(glm::dvec3 back, glm::dvec3 right);

/// The normal of the solid with its edges rounded off: the normal of the face in the middle part of a face, the mean
/// of the normals of the faces that meet at an edge or at a corner, and continuous between. On a small face the zone
/// at the edges is narrower. `place` is on the surface.
glm::dvec3 roundedNormal(const SolidMesh& mesh, glm::dvec3 place);

/// The line of sight is nearly the rounded normal, with a little of the ray from the solid's centre, so that the
/// neighbouring faces are seen. The player's right is level on the screen, except near a
/// corner. `zoom` is a magnification, more than 0.
CameraTarget cameraTarget(const Pose& player, const SolidMesh& mesh, double zoom);

}  // namespace platon
