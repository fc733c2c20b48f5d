#include "levels/reach/flight_envelope.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "platon/exact/integer.h"
#include "platon/game/game.h"
#include "platon/game/level.h"
#include "platon/game/player_motion.h"

namespace platon {
namespace {

constexpr double kSubunits = kSubunitsPerUnit;

// A player standing in the middle of a large face.
Game standingGame() {
  const LevelResult level = loadLevel("HEXAHEDRON\n0 0 20 0\n5 0 0\n20000\n%\n-9000 0 9000 0\n%\n%\n%\n%\n%\n");
  Game game(level.level);
  const Input still[] = {Input{Input::kPresent}};
  for (int tick = 0; tick < 60; ++tick) game.advance(still);
  return game;
}

double heightOf(const Game& game) { return game.world().entities()[0].position.y / kSubunits; }

// Height by which the steepest ground rises on a way of 1 along it.
double riseOfSteepestGround() { return std::sqrt(1 - kSteepestGroundNormalY * kSteepestGroundNormalY); }

// A tick on the ground takes this much, at least, from who is faster than a run.
constexpr std::int32_t kGroundFriction =
    std::min({motion::kGroundGrip.acceleration, motion::kGroundGrip.turnRound, motion::kGroundGrip.friction});
static_assert((FlightEnvelope::kPaces - 1) * kGroundFriction >= motion::kSlideSpeed - motion::kRunSpeed);

}  // namespace

const FlightEnvelope& FlightEnvelope::measured() {
  static const FlightEnvelope envelope;
  return envelope;
}

// One jump with the button held, until the player lands.
FlightEnvelope::FlightEnvelope() {
  Game game = standingGame();
  const double ground = heightOf(game);
  std::vector<double> heights;
  const Input held[] = {Input{Input::kPresent | Input::kJump}};
  do {
    game.advance(held);
    heights.push_back(heightOf(game));
  } while (game.player(0).ground == Point());
  const auto top = std::max_element(heights.begin(), heights.end());
  jumpHeight_ = *top - ground;
  for (auto before = top; before != heights.begin(); --before) below_.push_back(*top - *(before - 1));
  below_.push_back(jumpHeight_);
  for (auto after = top; after != heights.end() - 1; ++after) fallen_.push_back(*top - *after);
  steepestRise_ = riseOfSteepestGround();
  runSpeed_ = motion::kRunSpeed / kSubunits;
  slideSpeed_ = motion::kSlideSpeed / kSubunits;
  airFriction_ = std::min(motion::kAirGrip.friction, motion::kAirGrip.acceleration) / kSubunits;
  lateTicks_ = motion::kCoyoteTicks;
}

double FlightEnvelope::speedAfter(int ticks, double speed) const {
  return std::max(std::min(speed, runSpeed_), speed - ticks * airFriction_);
}

double FlightEnvelope::wayAside(int ticks, double speed) const {
  const int slowing = speed <= runSpeed_ ? 0 : std::min(ticks, static_cast<int>((speed - runSpeed_) / airFriction_));
  const double way = slowing * speed - airFriction_ * slowing * (slowing - 1) / 2;
  return way + (ticks - slowing) * speedAfter(slowing, speed);
}

// The player leaves the steepest ground: gravity acts from the second of the whole ticks before the jump.
double FlightEnvelope::slopeGain(double speed) const {
  const int falling = (lateTicks_ - 1) * (lateTicks_ - 2) / 2;
  return lateWay(speed) * steepestRise_ - motion::kGravity / kSubunits * falling;
}

// A slide along a segment turns at most half of what the horizontal speed adds to a displacement upwards: sin a cos a.
// Each contact takes that speed away, so it must be gained again.
double FlightEnvelope::pushGain(double speed) const {
  return (speed + motion::kAirGrip.acceleration / kSubunits * static_cast<double>(below_.size())) / 2;
}

// A contact with the segment leads to a speed between the one before it and that of who slides as fast as one falls. An
// overhang that turns more of the speed downwards before takes as much from the speed aside.
double FlightEnvelope::slidingSpeed(double tangent, double speed) const {
  constexpr double rounding = 0.01;
  return std::min(std::max(speed, motion::kFastFallSpeed / kSubunits / tangent + rounding), slideSpeed_);
}

double FlightEnvelope::speedOf(int pace) const {
  return std::min(runSpeed_ + pace * kGroundFriction / kSubunits, slideSpeed_);
}

int FlightEnvelope::paceOf(double speed) const {
  int pace = 0;
  while (pace + 1 < kPaces && speedOf(pace) < speed) ++pace;
  return pace;
}

double FlightEnvelope::speedAfterWay(double aside, double speed) const {
  const double most = (slideSpeed_ + std::hypot(slideSpeed_, motion::kFastFallSpeed / kSubunits)) / 2;
  return std::max(std::min(speed, runSpeed_), speed - aside / most * airFriction_);
}

double FlightEnvelope::lateFall() const { return motion::kGravity / kSubunits * lateTicks_ * (lateTicks_ - 1) / 2; }

int FlightEnvelope::riseTicks(double height) const {
  const auto found = std::lower_bound(below_.begin(), below_.end(), height);
  return static_cast<int>(found - below_.begin()) + 1;
}

// Beyond the measured fall, at the speed of its last tick, which is lower than that of any later one.
int FlightEnvelope::fallTicks(double depth) const {
  const auto found = std::lower_bound(fallen_.begin(), fallen_.end(), depth);
  const auto ticks = static_cast<int>(found - fallen_.begin());
  if (found != fallen_.end()) return ticks + 1;
  const double last = fallen_.back() - fallen_[fallen_.size() - 2];
  return ticks + static_cast<int>(std::ceil((depth - fallen_.back()) / last));
}

}  // namespace platon
