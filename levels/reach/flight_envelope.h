#pragma once

#include <vector>

#include "platon/game/player.h"
#include "platon/game/player_motion.h"

namespace platon {

/// y of the unit normal of the steepest ground. Player rounds normals, so that some that are as steep are none.
inline constexpr double kSteepestGroundNormalY = (double{1} * motion::kMinGroundNormalY - 1) / PlayerState::kUnit;

/// How far a player can get in the air, in level units and ticks. Measured on the game itself, once, so that no rule is
/// written a second time.
class FlightEnvelope {
 public:
  static const FlightEnvelope& measured();

  /// Height of a jump whose button is held.
  double jumpHeight() const { return jumpHeight_; }
  /// Most that a jump gains from the ground's slope: a run up a segment or over its end gives an upward speed, and the
  /// jump may come some ticks later.
  double slopeGain() const { return slopeGain_; }
  /// Most that a flight rises above what its speed gives, by sliding along ends and steep segments.
  double pushGain() const { return pushGain_; }
  /// Largest horizontal speed, a tick: of a run, and after a slide down a steep segment.
  double runSpeed() const { return runSpeed_; }
  double slideSpeed() const { return slideSpeed_; }
  /// Ticks after leaving the ground in which a jump is still possible.
  int lateTicks() const { return lateTicks_; }
  /// Until a jump after leaving the ground: the way that a run gives, in its direction, of which the part downwards is
  /// at most `steepestRise` of it; what gravity adds downwards; and the most downwards of both.
  double lateWay() const { return (lateTicks_ - 1) * runSpeed_; }
  double steepestRise() const { return steepestRise_; }
  double lateFall() const;
  double lateDepth() const { return lateWay() * steepestRise_ + lateFall(); }

  /// Horizontal speed at most after so many ticks in the air, and the way aside until then. Who has slid down a steep
  /// segment is faster than a run, until the air slows it.
  double speedAfter(int ticks, double speed) const;
  double wayAside(int ticks, double speed) const;
  /// Ticks of the slowest rise by the last `height` units below the highest point.
  int riseTicks(double height) const;
  /// Ticks of the slowest fall by `depth` units from rest.
  int fallTicks(double depth) const;

 private:
  FlightEnvelope();

  double jumpHeight_ = 0;
  double slopeGain_ = 0;
  double pushGain_ = 0;
  double runSpeed_ = 0;
  double slideSpeed_ = 0;
  double steepestRise_ = 0;  // of a way of 1 along the steepest ground
  double airFriction_ = 0;   // of the horizontal speed, a tick
  int lateTicks_ = 0;
  std::vector<double> below_;   // depth below the highest point, by ticks before it
  std::vector<double> fallen_;  // depth below the highest point, by ticks after it
};

}  // namespace platon
