#include "client/ui/steering.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

namespace platon {

Input Steering::input(const HeldKeys& keys, double roll, ControlFrame frame) {
  // Directions counter-clockwise from the right.
  const std::array<bool, 4> held{keys.right, keys.up, keys.left, keys.down};
  constexpr std::array<std::uint8_t, 4> kInputOf{Input::kRight, Input::kJump, Input::kLeft, Input::kDown};
  const bool anyHeld = keys.right || keys.up || keys.left || keys.down;
  if (frame == ControlFrame::kPlayer) {
    quarters_ = 0;
  } else if (!anyHeld) {
    quarters_ = static_cast<int>(std::lround(roll / (std::numbers::pi / 2)));
  }
  Input input{Input::kPresent};
  for (int direction = 0; direction < 4; ++direction) {
    const int turned = ((direction - quarters_) % 4 + 4) % 4;
    if (held[static_cast<std::size_t>(direction)]) input.buttons |= kInputOf[static_cast<std::size_t>(turned)];
  }
  if (keys.jump) input.buttons |= Input::kJump;
  if (keys.walk) input.buttons |= Input::kWalk;
  if (keys.creep) input.buttons |= Input::kCreep;
  if (keys.restart) input.buttons |= Input::kRestart;
  return validInput(input.buttons);
}

}  // namespace platon
