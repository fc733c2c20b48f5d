#pragma once

#include <cstdint>

/// How a player moves. Speeds are in subunits per tick, accelerations in subunits per tick squared; a second has 60
/// ticks, a unit 1024 subunits.
namespace platon::motion {

inline constexpr std::int32_t kRunSpeed = 3277;    // 192 units per second
inline constexpr std::int32_t kWalkSpeed = 2185;   // two thirds
inline constexpr std::int32_t kCreepSpeed = 1092;  // one third
/// Changes of the speed: towards the pressed direction, against the present one, and without a direction.
struct Grip {
  std::int32_t acceleration;
  std::int32_t turnRound;
  std::int32_t friction;
};
inline constexpr Grip kGroundGrip{410, 956, 546};
inline constexpr Grip kAirGrip{205, 410, 51};
inline constexpr std::int32_t kGravity = 300;
/// In a jump, while its button is held, half the gravity acts on vertical speeds up to this.
inline constexpr std::int32_t kApexSpeed = 1600;
inline constexpr std::int32_t kJumpSpeed = 6024;     // a full jump rises 61350 subunits: 59.9 units
inline constexpr std::int32_t kCutJumpSpeed = 1800;  // largest upward speed once the button is released
inline constexpr std::int32_t kFallSpeed = 5632;
inline constexpr std::int32_t kFastFallSpeed = 7680;  // while the down button is held
/// Largest horizontal speed. A slide down a steep segment can be faster than a run.
inline constexpr std::int32_t kSlideSpeed = 6144;
/// Displacement a tick that presses a standing player to the ground, so that it follows gentle slopes and edges. Not
/// part of the velocity.
inline constexpr std::int32_t kGroundPress = 512;
inline constexpr std::uint8_t kCoyoteTicks = 6;
inline constexpr std::uint8_t kJumpBufferTicks = 6;
/// Smallest y of a unit normal of ground: PlayerState::kUnit * cos 50°. Steeper segments are not ground.
inline constexpr std::int32_t kMinGroundNormalY = 10531;
/// Smallest |x| of a unit normal at which the end of a segment lets a player pass: kUnit * sin 44°. The player's shape
/// has such normals where the end reaches at most 5.1 units under its outermost point.
inline constexpr std::int32_t kMinPassingNormalX = 11381;

}  // namespace platon::motion
