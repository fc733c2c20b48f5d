#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "client/scene/pose.h"

namespace platon {

/// How far the middle of the picture leads the player, from the way that the player has gone lately. A point trails the
/// player; the lead is a function of the distance to it. Small turns and jumps keep that distance small. Against a
/// jump, the lead is negative: the picture rises less than the player.
class CameraLead {
 public:
  static constexpr double kTrailRate = 1.5;  ///< rate of the approach of the trailing point to the player, per second
  static constexpr double kMaxLead = 65;     ///< level units, in each direction

  /// The player stands still.
  void reset(const Pose& player);
  /// The player has moved here.
  void move(const Pose& player);
  /// The trailing point approaches the player for `seconds` ≥ 0.
  void wait(double seconds);

  /// Where a point is after `seconds` ≥ 0 that starts at the player, who stands still, and approaches the lead at the
  /// rate `follow`, which is not kTrailRate: to the player's right and along its up, level units. With `reduced`
  /// nothing leads the player.
  glm::dvec2 followed(double follow, double seconds, bool reduced) const;

 private:
  glm::dvec3 place_{0};  // of the player
  glm::dvec2 trail_{0};  // from the trailing point to the player: to the player's right and along its up
};

}  // namespace platon
