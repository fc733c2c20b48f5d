#pragma once

#include <cstdint>

namespace platon {

/// Buttons of one slot in one tick, one bit each. Joining and leaving are inputs, too: a slot without `kPresent` has no
/// player.
struct Input {
  static constexpr std::uint8_t kLeft = 1;
  static constexpr std::uint8_t kRight = 2;
  static constexpr std::uint8_t kJump = 4;
  static constexpr std::uint8_t kDown = 8;      ///< falls faster
  static constexpr std::uint8_t kRestart = 16;  ///< moves the player back to the start of the level
  static constexpr std::uint8_t kWalk = 32;     ///< with left or right: two thirds of the run speed
  static constexpr std::uint8_t kCreep = 64;    ///< with left or right: one third of the run speed
  static constexpr std::uint8_t kPresent = 128;
  static constexpr std::uint8_t kDirections = kLeft | kRight;
  static constexpr std::uint8_t kSpeeds = kWalk | kCreep;
  /// Buttons that move the player.
  static constexpr std::uint8_t kMoves = kDirections | kJump | kDown;

  std::uint8_t buttons = 0;

  constexpr bool has(std::uint8_t button) const { return (buttons & button) != 0; }
  friend constexpr bool operator==(Input, Input) = default;
};

/// Whether an input is valid: no buttons without `kPresent`, at most one direction, at most one speed, and that only
/// with a direction.
constexpr bool isInput(Input input) {
  const int directions = input.buttons & Input::kDirections;
  const int speeds = input.buttons & Input::kSpeeds;
  if (!input.has(Input::kPresent)) return input.buttons == 0;
  return directions != Input::kDirections && speeds != Input::kSpeeds && (speeds == 0 || directions != 0);
}

/// The input with these buttons: opposite directions cancel each other, of two speeds the lower one counts, and a speed
/// without a direction is dropped.
constexpr Input validInput(std::uint8_t buttons) {
  if ((buttons & Input::kPresent) == 0) return {};
  if ((buttons & Input::kDirections) == Input::kDirections) buttons &= std::uint8_t{0xff} ^ Input::kDirections;
  if ((buttons & Input::kDirections) == 0) buttons &= std::uint8_t{0xff} ^ Input::kSpeeds;
  if ((buttons & Input::kSpeeds) == Input::kSpeeds) buttons &= std::uint8_t{0xff} ^ Input::kWalk;
  return {buttons};
}

}  // namespace platon
