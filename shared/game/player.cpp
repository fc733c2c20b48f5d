#include "platon/game/player.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "platon/exact/integer.h"

namespace platon {
namespace {

// Subunits a tick, and subunits a tick squared; 60 ticks a second, 1024 subunits a unit.
constexpr std::int32_t kRunSpeed = 3277;  // 192 units a second
constexpr std::int32_t kGroundAcceleration = 410;
constexpr std::int32_t kAirAcceleration = 205;
constexpr std::int32_t kGroundFriction = 546;
constexpr std::int32_t kAirFriction = 51;
constexpr std::int32_t kGravity = 256;
constexpr std::int32_t kJumpSpeed = 5734;     // about 62 units high
constexpr std::int32_t kCutJumpSpeed = 1800;  // what is left of it when the button is let go
constexpr std::int32_t kFallSpeed = 12288;
// A standing player is pressed to the ground by this much, so that it follows gentle slopes and edges; the press is no
// part of the velocity.
constexpr std::int32_t kPress = 512;
constexpr std::uint8_t kCoyoteTicks = 6;
constexpr std::uint8_t kJumpBufferTicks = 6;
// Ground is what is at most 50 degrees steep: cos 50° of a unit.
constexpr std::int32_t kGroundNormal = 10531;

std::int32_t towards(std::int32_t value, std::int32_t target, std::int32_t step) {
  return value < target ? std::min(value + step, target) : std::max(value - step, target);
}

// `vector` times length / kUnit.
Point scaled(Point vector, std::int64_t length) {
  return {static_cast<std::int32_t>(divideRounded<std::int64_t>(vector.x * length, PlayerState::kUnit)),
          static_cast<std::int32_t>(divideRounded<std::int64_t>(vector.y * length, PlayerState::kUnit))};
}

// The part of `vector` along a unit vector.
std::int32_t along(Point vector, Point direction) {
  return static_cast<std::int32_t>(divideRounded<std::int64_t>(dot(vector, direction), PlayerState::kUnit));
}

// To the right along the ground; in the air simply to the right.
Point tangentOf(Point ground) { return ground == Point() ? Point(PlayerState::kUnit, 0) : -perpendicular(ground); }

}  // namespace

Convex playerShape() {
  std::vector<Point> vertices;
  // The first corner to the right of the bottom edge; -78.75 degrees.
  for (std::int32_t i = 0; i < 16; ++i) vertices.push_back(rotate(Point(kPlayerRadius, 0), Angle(-7875 + i * 2250)));
  return Convex(std::move(vertices));
}

void Player::tick(Input input) {
  run(input);
  jump(input);
  state_->held = input.buttons;
  fall();
  const Point press = scaled(-state_->ground, kPress);
  setVelocity(state_->velocity + press, up());
  state_->ground = Point();  // until a contact says otherwise
}

void Player::run(Input input) {
  const bool grounded = state_->ground != Point();
  const Point tangent = tangentOf(state_->ground);
  const int direction = int{input.has(Input::kRight)} - int{input.has(Input::kLeft)};
  const std::int32_t step = direction == 0 ? (grounded ? kGroundFriction : kAirFriction)
                                           : (grounded ? kGroundAcceleration : kAirAcceleration);
  const std::int32_t speed = towards(along(state_->velocity, tangent), direction * kRunSpeed, step);
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
  const bool landing = normal.y >= kGroundNormal;
  const bool wasInAir = state_->coyote != kCoyoteTicks - 1;
  if (landing) {
    state_->ground = normal;
  } else {
    holdBetween(normal, steep);
  }
  Point& velocity = state_->velocity;
  const std::int32_t inwards = along(velocity, normal);
  if (inwards >= 0) return;
  if (landing && wasInAir) {
    velocity = scaled(tangentOf(normal), velocity.x);  // a fall ends in a run, not in a slide down the slope
  } else {
    velocity -= scaled(normal, inwards);
  }
}

// Between a steep line and another one that faces it, be it steep, a wall or an overhang, one stands: else there would
// be no way out.
void Player::holdBetween(Point normal, Point& steep) {
  const bool opposite = (normal.x > 0 && steep.x < 0) || (normal.x < 0 && steep.x > 0);
  const bool upwards = normal.y > 0 || steep.y > 0;
  if (opposite && upwards && state_->ground == Point()) state_->ground = Point(0, PlayerState::kUnit);
  if (normal.x != 0) steep = normal;  // a flat ceiling faces neither
}

}  // namespace platon
