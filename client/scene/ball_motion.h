#pragma once

#include <deque>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "client/scene/solid_mesh.h"
#include "client/scene/stage_model.h"
#include "levels/drawing/colour.h"

namespace platon {

/// Unit vector from a point of the surface to the centre of a ball of `radius` that lies there. It is the normal of the
/// face where the point is farther than the radius from every edge, and turns continuously from one normal to the other
/// over an edge, on which it bisects them.
glm::dvec3 liftAt(const SolidMesh& mesh, glm::dvec3 point, double radius);

/// How the ball of a player moves, as its picture shows it: computed from its poses alone. It decides nothing.
class BallMotion {
 public:
  static constexpr double kMaxStep = 60;  ///< a longer way between two pictures is a jump, such as a restart
  static constexpr double kTrailSeconds = 0.5;
  static constexpr double kDustSeconds = 0.45;
  static constexpr double kMaxSquash = 0.22;

  explicit BallMotion(double radius) : radius_(radius) {}

  /// The ball is at `pose` at `seconds`. A time before the last one, or a jump, begins anew.
  void advance(const SolidMesh& mesh, const Pose& pose, double seconds);

  /// Turns what is drawn, with the face on which the ball lies.
  void turn(glm::dquat turn);
  /// Ends the squash of a landing.
  void settle() { squash_ = 0; }

  /// Unit vector from the pose to the centre of the ball.
  glm::dvec3 lift() const { return lift_; }
  /// How the ball has rolled, from the start.
  glm::dquat orientation() const { return orientation_; }
  /// How much the ball is shorter along its up, 0 … kMaxSquash, shortly after a landing.
  double squash() const { return squash_; }
  /// Appends the trail, and the dust of landings and take-offs, which is in the colour of walls.
  void addMarks(Colour ball, Colour wall, std::vector<FaceMark>& marks) const;

 private:
  // A place on the surface and when the ball was there.
  struct Spot {
    int face = 0;
    glm::vec2 place{0};
    glm::vec2 up{0, 1};  // of the ball
    double seconds = 0;
  };

  void begin(const SolidMesh& mesh, const Pose& pose, double seconds);
  void roll(glm::dvec3 way);
  void feelGround(const Spot& spot, double rise, double passed);
  void forget(double seconds);
  static Spot spotOf(const SolidMesh& mesh, const Pose& pose, double seconds);

  double radius_;
  bool begun_ = false;
  Pose pose_;
  double seconds_ = 0;
  double rise_ = 0;  // speed along up, level units a second
  glm::dvec3 lift_{0, 0, 1};
  glm::dquat orientation_{1, 0, 0, 0};
  double squash_ = 0;
  std::deque<Spot> trail_;
  std::deque<Spot> dust_;
};

}  // namespace platon
