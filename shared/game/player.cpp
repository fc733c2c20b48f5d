#include "platon/game/player.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "platon/exact/integer.h"

namespace platon {
namespace {

// Speeds are in subunits per tick, accelerations in subunits per tick squared; a second has 60 ticks, a unit 1024
// subunits.
constexpr std::int32_t kRunSpeed = 3277;  // 192 units per second
constexpr std::int32_t kGroundAcceleration = 410;
constexpr std::int32_t kAirAcceleration = 205;
constexpr std::int32_t kGroundFriction = 546;
constexpr std::int32_t kAirFriction = 51;
constexpr std::int32_t kGravity = 256;
constexpr std::int32_t kJumpSpeed = 5734;     // a full jump rises 61380 subunits: 59.9 units
constexpr std::int32_t kCutJumpSpeed = 1800;  // largest upward speed once the button is released
constexpr std::int32_t kFallSpeed = 12288;
// Displacement a tick that presses a standing player to the ground, so that it follows gentle slopes and edges. Not
// part of the velocity.
constexpr std::int32_t kGroundPress = 512;
constexpr std::uint8_t kCoyoteTicks = 6;
constexpr std::uint8_t kJumpBufferTicks = 6;
// Smallest y of a unit normal of ground: PlayerState::kUnit * cos 50°. Steeper segments are not ground.
constexpr std::int32_t kMinGroundNormalY = 10531;

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
  const std::int32_t step = direction == 0 ? (grounded ? kGroundFriction : kAirFriction)
                                           : (grounded ? kGroundAcceleration : kAirAcceleration);
  const std::int32_t speed = approach(along(state_->velocity, tangent), direction * kRunSpeed, step);
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
    state_->velocity.y = std::max(state_->velocity.y, 0) + kJumpSpeed;
    state_->ground = Point();
    state_->jumpBuffer = state_->coyote = 0;
    state_->rising = 1;
    return;
  }
  if (state_->coyote != 0) --state_->coyote;
  if (state_->jumpBuffer != 0) --state_->jumpBuffer;
}

void Player::fall() {
  if (state_->ground != Point()) {
    state_->rising = 0;
    return;
  }
  if (state_->rising != 0 && (state_->held & Input::kJump) == 0 && state_->velocity.y > kCutJumpSpeed) {
    state_->velocity.y = kCutJumpSpeed;
  }
  if (state_->velocity.y <= kCutJumpSpeed) state_->rising = 0;
  state_->velocity.y = std::max(state_->velocity.y - kGravity, -kFallSpeed);
}

void Player::contact(Point normal, Point& steep) {
  const bool landing = normal.y >= kMinGroundNormalY;
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
  } else {
    velocity -= scaled(normal, inwards);
  }
}

// A player between a steep segment and an opposite one (steep, vertical or overhanging) stands, so that it can jump
// out.
void Player::standInWedge(Point normal, Point& steep) {
  const bool opposite = (normal.x > 0 && steep.x < 0) || (normal.x < 0 && steep.x > 0);
  const bool upwards = normal.y > 0 || steep.y > 0;
  if (opposite && upwards && state_->ground == Point()) state_->ground = Point(0, PlayerState::kUnit);
  if (normal.x != 0) steep = normal;  // a horizontal ceiling has no opposite segment
}

}  // namespace platon
