#include "platon/game/player.h"

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

#include "platon/exact/integer.h"
#include "platon/game/player_motion.h"

namespace platon {

using namespace motion;

namespace {

// `value` changed by at most `step` towards `target`.
std::int32_t approach(std::int32_t value, std::int32_t target, std::int32_t step) {
  return value < target ? std::min(value + step, target) : std::max(value - step, target);
}

// `vector` * `length` / kUnit, rounded.
Point scaled(Point vector, std::int64_t length) {
  return {static_cast<std::int32_t>(divideRounded<std::int64_t>(vector.x * length, PlayerState::kUnit)),
          static_cast<std::int32_t>(divideRounded<std::int64_t>(vector.y * length, PlayerState::kUnit))};
}

// Component of `vector` along a unit vector.
std::int32_t along(Point vector, Point direction) {
  return static_cast<std::int32_t>(divideRounded<std::int64_t>(dot(vector, direction), PlayerState::kUnit));
}

std::int32_t runSpeedOf(Input input) {
  if (input.has(Input::kCreep)) return kCreepSpeed;
  return input.has(Input::kWalk) ? kWalkSpeed : kRunSpeed;
}

// Unit vector to the right: along the ground, or horizontal in the air.
Point tangentOf(Point ground) { return ground == Point() ? Point(PlayerState::kUnit, 0) : -perpendicular(ground); }

}  // namespace

Convex playerShape() {
  std::vector<Point> vertices;
  // The first vertex is the right end of the bottom edge, at -78.75 degrees.
  for (std::int32_t i = 0; i < 16; ++i) vertices.push_back(rotate(Point(kPlayerRadius, 0), Angle(-7875 + i * 2250)));
  return Convex(std::move(vertices));
}

void Player::tick(Input input) {
  run(input);
  jump(input);
  state_->held = input.buttons;
  fall();
  const Point press = scaled(-state_->ground, kGroundPress);
  setVelocity(state_->velocity + press, up());
  state_->ground = Point();  // contact() sets it again
}

void Player::run(Input input) {
  const bool grounded = state_->ground != Point();
  const Point tangent = tangentOf(state_->ground);
  const int direction = int{input.has(Input::kRight)} - int{input.has(Input::kLeft)};
  const Grip& grip = grounded ? kGroundGrip : kAirGrip;
  const std::int32_t before = along(state_->velocity, tangent);
  const std::int32_t step = direction == 0           ? grip.friction
                            : direction * before < 0 ? std::min(grip.turnRound, std::abs(before) + grip.acceleration)
                                                     : grip.acceleration;
  const std::int32_t speed = approach(before, direction * runSpeedOf(input), step);
  if (grounded) {
    state_->velocity = scaled(tangent, speed);
  } else {
    state_->velocity.x = speed;
  }
}

void Player::jump(Input input) {
  const bool pressed = input.has(Input::kJump) && (state_->held & Input::kJump) == 0;
  if (state_->ground != Point()) state_->coyote = kCoyoteTicks;
  if (pressed) state_->jumpBuffer = kJumpBufferTicks;
  if (state_->jumpBuffer != 0 && state_->coyote != 0) {
    state_->velocity.y = kJumpSpeed;
    state_->ground = Point();
    state_->jumpBuffer = state_->coyote = 0;
    state_->jumping = 1;
    return;
  }
  if (state_->coyote != 0) --state_->coyote;
  if (state_->jumpBuffer != 0) --state_->jumpBuffer;
}

void Player::fall() {
  if (state_->ground != Point()) {
    state_->jumping = 0;
    return;
  }
  std::int32_t& speed = state_->velocity.y;
  if (state_->jumping != 0 && (state_->held & Input::kJump) == 0) {
    speed = std::min(speed, kCutJumpSpeed);
    state_->jumping = 0;
  }
  if (speed < -kApexSpeed) state_->jumping = 0;
  const std::int32_t gravity = state_->jumping != 0 && speed <= kApexSpeed ? kGravity / 2 : kGravity;
  speed = approach(speed, (state_->held & Input::kDown) != 0 ? -kFastFallSpeed : -kFallSpeed, gravity);
}

void Player::contact(Point normal, bool atEnd, Point& steep) {
  const bool landing = isGround(normal);
  const bool wasInAir = state_->coyote != kCoyoteTicks - 1;  // `jump` has set it, less one, for a player on the ground
  if (landing) {
    state_->ground = normal;
  } else {
    standInWedge(normal, steep);
  }
  Point& velocity = state_->velocity;
  const std::int32_t inwards = along(velocity, normal);
  if (inwards >= 0) return;
  if (landing && wasInAir) {
    // Keeps the horizontal speed, so that a landing on a slope does not start a slide.
    velocity = scaled(tangentOf(normal), velocity.x);
  } else if (atEnd && !landing && std::abs(normal.x) >= kMinPassingNormalX) {
    // The player slides round the end of a ceiling or of a ledge and keeps its vertical speed.
    if (velocity.x * normal.x < 0) velocity.x = 0;
  } else {
    const std::int32_t before = velocity.y;
    velocity -= scaled(normal, inwards);
    if (!landing && normal.y > 0) limitClimb(std::max(before, 0));
  }
  velocity.x = std::clamp(velocity.x, -kSlideSpeed, kSlideSpeed);
}

// Nobody climbs what is too steep to stand on: the velocity, which is along such a segment, gets no larger upward speed
// than it had before the contact.
void Player::limitClimb(std::int32_t upwards) {
  Point& velocity = state_->velocity;
  state_->jumping = 0;
  if (velocity.y <= upwards) return;
  velocity.x = static_cast<std::int32_t>(std::int64_t{velocity.x} * upwards / velocity.y);
  velocity.y = upwards;
}

bool Player::isGround(Point normal) { return normal.y >= kMinGroundNormalY; }

// A player between a steep segment and an opposite one (steep, vertical or overhanging) stands, so that it can jump
// out.
void Player::standInWedge(Point normal, Point& steep) {
  const bool opposite = (normal.x > 0 && steep.x < 0) || (normal.x < 0 && steep.x > 0);
  const bool upwards = normal.y > 0 || steep.y > 0;
  if (opposite && upwards && state_->ground == Point()) state_->ground = Point(0, PlayerState::kUnit);
  if (normal.x != 0) steep = normal;  // a horizontal ceiling has no opposite segment
}

}  // namespace platon
