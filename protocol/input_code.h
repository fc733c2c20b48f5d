#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "platon/game/input.h"

namespace platon {

/// An input on the wire: 6 bits. The low 3 bits are the direction with its speed, or kAbsentCode for a slot without a
/// player; the others are jump, down and restart.
inline constexpr int kInputCodeBits = 6;
inline constexpr std::uint8_t kAbsentCode = 7;
inline constexpr std::uint8_t kInputCodeMask = (1 << kInputCodeBits) - 1;

namespace input_code {

inline constexpr std::uint8_t kDirectionMask = 7;
inline constexpr std::array<std::uint8_t, 7> kDirections = {0,
                                                            Input::kLeft,
                                                            Input::kRight,
                                                            Input::kLeft | Input::kWalk,
                                                            Input::kRight | Input::kWalk,
                                                            Input::kLeft | Input::kCreep,
                                                            Input::kRight | Input::kCreep};
// From jump, down and restart to the bits above the direction.
inline constexpr int kShift = 1;
inline constexpr std::uint8_t kOthers = Input::kJump | Input::kDown | Input::kRestart;
static_assert((kOthers << kShift & kDirectionMask) == 0 && (kOthers << kShift) < 1 << kInputCodeBits);

}  // namespace input_code

/// The code of an input; of an invalid one, that of validInput.
constexpr std::uint8_t codeOf(Input input) {
  if (!input.has(Input::kPresent)) return kAbsentCode;
  input = validInput(input.buttons);
  const int moving = input.buttons & (Input::kDirections | Input::kSpeeds);
  std::uint8_t code = 0;
  while (input_code::kDirections[code] != moving) ++code;
  return static_cast<std::uint8_t>(code | (input.buttons & input_code::kOthers) << input_code::kShift);
}

/// The input with this code, below 2^kInputCodeBits. Nothing for a slot without a player that presses buttons.
constexpr std::optional<Input> inputOf(std::uint8_t code) {
  const std::uint8_t direction = code & input_code::kDirectionMask;
  if (direction == kAbsentCode) return code == kAbsentCode ? std::optional(Input()) : std::nullopt;
  const int others = code >> input_code::kShift & input_code::kOthers;
  return Input{static_cast<std::uint8_t>(Input::kPresent | input_code::kDirections[direction] | others)};
}

}  // namespace platon
