#pragma once

#include <cstdint>

namespace platon {

/// What one player slot does in one tick: one byte of buttons. Joining and leaving are inputs like all else: a slot
/// without `kPresent` has no player.
struct Input {
  static constexpr std::uint8_t kLeft = 1;
  static constexpr std::uint8_t kRight = 2;
  static constexpr std::uint8_t kJump = 4;
  static constexpr std::uint8_t kDown = 8;
  static constexpr std::uint8_t kRestart = 16;  ///< back to the start
  static constexpr std::uint8_t kPresent = 128;
  static constexpr std::uint8_t kAll = kLeft | kRight | kJump | kDown | kRestart | kPresent;

  std::uint8_t buttons = 0;

  constexpr bool has(std::uint8_t button) const { return (buttons & button) != 0; }
  friend constexpr bool operator==(Input, Input) = default;
};

/// Whether a byte from outside may be an input: known buttons only, and none of a slot that nobody plays.
constexpr bool isInput(Input input) {
  return (input.buttons & ~Input::kAll) == 0 && (input.has(Input::kPresent) || input.buttons == 0);
}

}  // namespace platon
