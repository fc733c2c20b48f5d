#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "client/scene/solid_mesh.h"

namespace platon {

/// Where an eye is, and its axes right, up and back.
struct ViewPoint {
  glm::dquat orientation{1, 0, 0, 0};
  glm::dvec3 eye{0, 0, 1000};  ///< level units, from the solid's centre

  glm::dvec3 right() const { return orientation * glm::dvec3(1, 0, 0); }
  glm::dvec3 up() const { return orientation * glm::dvec3(0, 1, 0); }
  glm::dvec3 back() const { return orientation * glm::dvec3(0, 0, 1); }
  /// The centre of the solid seen from the eye, negated: how far the eye is to the right of, above and behind it.
  glm::dvec3 fromCentre() const { return glm::conjugate(orientation) * eye; }
};

/// The view in this orientation from `fromCentre`, drawn back by `part` (0 … 1) of the way to where the whole solid
/// fills the picture. The eye is never in the solid.
ViewPoint drawnBack(const SolidMesh& mesh, glm::dquat orientation, glm::dvec3 fromCentre, double part);

/// The angle of a turn, 0 … 2 π: more than π where the quaternion stands for the longer way.
double angleOfTurn(const glm::dquat& turn);
/// A part of a turn, 0 … 1.
glm::dquat partOf(const glm::dquat& turn, double part);

/// What is left of `distance` ≥ 0 after `seconds` ≥ 0 of an approach at `rate` × the rest a second, but at `maxSpeed` a
/// second at most. Rate and speed are more than 0. Two calls in turn equal one call with the sum of their times.
double leftAfter(double distance, double rate, double maxSpeed, double seconds);

/// A way from 0 to 1 that begins and ends without a jerk, at `part` (0 … 1) of its time.
double smootherstep(double part);

}  // namespace platon
