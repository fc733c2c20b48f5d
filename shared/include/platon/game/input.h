#pragma once

#include <cstdint>

namespace platon {

/// Buttons of one slot in one tick, one bit each. Joining and leaving are inputs, too: a slot without `kPresent` has no
/// player.
struct Input {
  static constexpr std::uint8_t kLeft = 1;
  static constexpr std::uint8_t kRight = 2;
  static constexpr std::uint8_t kJump = 4;
  static constexpr std::uint8_t kDown = 8;
  static constexpr std::uint8_t kRestart = 16;  ///< moves the player back to the start of the level
  static constexpr std::uint8_t kPresent = 128;
  static constexpr std::uint8_t kAll = kLeft | kRight | kJump | kDown | kRestart | kPresent;

  std::uint8_t buttons = 0;

  constexpr bool has(std::uint8_t button) const { return (buttons & button) != 0; }
  friend constexpr bool operator==(Input, Input) = default;
};

/// True when a byte from outside is a valid input: only known buttons, and none without `kPresent`.
constexpr bool isInput(Input input) {
  return (input.buttons & ~Input::kAll) == 0 && (input.has(Input::kPresent) || input.buttons == 0);
}

}  // namespace platon
