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
  /// Most that a jump gains from the ground's slope: at this speed, a run up a segment or over its end gives an upward
  /// speed, and the jump may come some ticks later.
  double slopeGain(double speed) const;
  /// Most that a flight rises above what its speed gives, by sliding along ends and steep segments.
  double pushGain(double speed) const;
  /// Largest horizontal speed, a tick: of a run, and after a slide down a steep segment.
  double runSpeed() const { return runSpeed_; }
  double slideSpeed() const { return slideSpeed_; }
  /// Horizontal speed at most of who had this one before a slide down a steep segment, whose slope has this tangent.
  double slidingSpeed(double tangent, double speed) const;
  /// Speeds at which a player lands, in steps of the least that a tick on the ground takes from one that is faster than
  /// a run: pace 0 is a run, the last one a slide.
  static constexpr int kPaces = 8;
  double speedOf(int pace) const;
  /// The slowest pace that is not below this speed.
  int paceOf(double speed) const;
  /// Ticks after leaving the ground in which a jump is still possible.
  int lateTicks() const { return lateTicks_; }
  /// Until a jump after leaving the ground, the rest of the tick in which it is left included: the way that the speed
  /// on the ground gives, in its direction, of which the part downwards is at most `steepestRise` of it; what gravity
  /// adds downwards; and the most downwards of both.
  double lateWay(double speed) const { return lateTicks_ * speed; }
  double steepestRise() const { return steepestRise_; }
  double lateFall() const;
  double lateDepth(double speed) const { return lateWay(speed) * steepestRise_ + lateFall(); }

  /// Horizontal speed at most after so many ticks in the air, and the way aside until then. Who has slid down a steep
  /// segment is faster than a run, until the air slows it.
  double speedAfter(int ticks, double speed) const;
  double wayAside(int ticks, double speed) const;
  /// Speed at most after a way aside in the air: a tick leads at most as far as a slide that meets a segment.
  double speedAfterWay(double aside, double speed) const;
  /// Ticks of the slowest rise by the last `height` units below the highest point.
  int riseTicks(double height) const;
  /// Ticks of the slowest fall by `depth` units from rest.
  int fallTicks(double depth) const;

 private:
  FlightEnvelope();

  double jumpHeight_ = 0;
  double runSpeed_ = 0;
  double slideSpeed_ = 0;
  double steepestRise_ = 0;  // of a way of 1 along the steepest ground
  double airFriction_ = 0;   // of the horizontal speed, a tick
  int lateTicks_ = 0;
  std::vector<double> below_;   // depth below the highest point, by ticks before it
  std::vector<double> fallen_;  // depth below the highest point, by ticks after it
};

}  // namespace platon
