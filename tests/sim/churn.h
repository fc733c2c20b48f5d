#pragma once

#include <cstdint>
#include <vector>

#include "platon/game/input.h"
#include "tests/sim/button_presses.h"
#include "tests/sim/seeded_random.h"

namespace platon::sim {

/// Seeded inputs of players who press every button, restart, leave and join: everything a recording can contain.
class Churn {
 public:
  Churn(std::uint64_t seed, std::uint32_t slots) : random_(seed), present_(slots, true), inputs_(slots) {
    for (std::uint32_t slot = 0; slot < slots; ++slot) presses_.emplace_back(seed, slot);
  }

  /// Inputs of the next tick, by slot.
  const std::vector<Input>& next() {
    for (std::size_t slot = 0; slot < inputs_.size(); ++slot) {
      if (random_.below(present_[slot] ? 900 : 60) == 0) present_[slot] = !present_[slot];
      Input pressed = presses_[slot].next();
      if (random_.below(400) == 0) pressed.buttons |= Input::kRestart;
      if (random_.below(40) == 0) pressed.buttons |= Input::kDown;
      if (random_.below(40) == 0) pressed.buttons |= Input::kWalk;
      if (random_.below(40) == 0) pressed.buttons |= Input::kCreep;
      inputs_[slot] = present_[slot] ? validInput(pressed.buttons) : Input();
    }
    return inputs_;
  }

 private:
  SeededRandom random_;
  std::vector<ButtonPresses> presses_;
  std::vector<bool> present_;
  std::vector<Input> inputs_;
};

}  // namespace platon::sim
