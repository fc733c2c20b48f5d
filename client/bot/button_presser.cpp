#include "client/bot/button_presser.h"

#include <array>

#include "platon/game/game.h"

namespace platon {

Input ButtonPresser::next() {
  if (ticksLeft_ == 0) {
    held_ = otherButtons();
    const std::uint32_t shortest = kTicksPerSecond / 6;
    ticksLeft_ = shortest + below(kTicksPerSecond / 3 - shortest + 1);
  }
  --ticksLeft_;
  return {held_};
}

std::uint8_t ButtonPresser::otherButtons() {
  // Weighted towards running and jumping.
  static constexpr std::array<std::uint8_t, 8> kCombinations = {Input::kRight,
                                                                Input::kLeft,
                                                                Input::kRight | Input::kJump,
                                                                Input::kLeft | Input::kJump,
                                                                Input::kRight,
                                                                Input::kJump,
                                                                0,
                                                                Input::kLeft | Input::kDown};
  std::uint8_t chosen = held_;
  while (chosen == held_) chosen = kCombinations[below(kCombinations.size())];
  return chosen;
}

}  // namespace platon
