#include "platon/game/player.h"

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

#include "platon/exact/integer.h"

namespace platon {
namespace {

// Speeds are in subunits per tick, accelerations in subunits per tick squared; a second has 60 ticks, a unit 1024
// subunits.
constexpr std::int32_t kRunSpeed = 3277;    // 192 units per second
constexpr std::int32_t kWalkSpeed = 2185;   // two thirds
constexpr std::int32_t kCreepSpeed = 1092;  // one third
// Changes of the speed: towards the pressed direction, against the present one, and without a direction.
struct Grip {
  std::int32_t acceleration;
  std::int32_t turnRound;
  std::int32_t friction;
};
constexpr Grip kGroundGrip{410, 956, 546};
constexpr Grip kAirGrip{205, 410, 51};
constexpr std::int32_t kGravity = 300;
// In a jump, while its button is held, half the gravity acts on vertical speeds up to this.
constexpr std::int32_t kApexSpeed = 1600;
constexpr std::int32_t kJumpSpeed = 6024;     // a full jump rises 61350 subunits: 59.9 units
constexpr std::int32_t kCutJumpSpeed = 1800;  // largest upward speed once the button is released
constexpr std::int32_t kFallSpeed = 5632;
constexpr std::int32_t kFastFallSpeed = 7680;  // while the down button is held
// Largest horizontal speed. A slide down a steep segment can be faster than a run.
constexpr std::int32_t kSlideSpeed = 6144;
// Displacement a tick that presses a standing player to the ground, so that it follows gentle slopes and edges. Not
// part of the velocity.
constexpr std::int32_t kGroundPress = 512;
constexpr std::uint8_t kCoyoteTicks = 6;
constexpr std::uint8_t kJumpBufferTicks = 6;
// Smallest y of a unit normal of ground: PlayerState::kUnit * cos 50°. Steeper segments are not ground.
constexpr std::int32_t kMinGroundNormalY = 10531;
// Smallest |x| of a unit normal at which the end of a ceiling lets a rising player pass: kUnit * sin 44°. The player's
// shape has such normals where the end reaches at most 5.1 units under its outermost point.
constexpr std::int32_t kMinPassingNormalX = 11381;

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
  const bool wasInAir = state_->coyote != kCoyoteTicks - 1;
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
  } else if (atEnd && velocity.y > 0 && normal.y < 0 && std::abs(normal.x) >= kMinPassingNormalX) {
    // The end of a ceiling: the player slides round it and keeps its height of jump.
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
