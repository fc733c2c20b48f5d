#pragma once

#include <cstdint>

#include "platon/game/input.h"
#include "tests/sim/seeded_random.h"

namespace platon::sim {

/// Seeded inputs of a player who changes buttons at the pace of a person: every 5 to 44 ticks.
class ButtonPresses {
 public:
  ButtonPresses(std::uint64_t seed, std::uint32_t slot) : random_(seed * 0x100000001b3U + slot) {}

  /// Input of the next tick.
  Input next() {
    if (ticksLeft_ == 0) {
      ticksLeft_ = 5 + random_.below(40);
      const auto direction = random_.below(8);
      buttons_ = direction < 3 ? Input::kLeft : direction < 6 ? Input::kRight : std::uint8_t{0};
      if (random_.below(2) == 0) buttons_ = static_cast<std::uint8_t>(buttons_ | Input::kJump);
    }
    --ticksLeft_;
    return {static_cast<std::uint8_t>(buttons_ | Input::kPresent)};
  }

 private:
  SeededRandom random_;
  std::uint64_t ticksLeft_ = 0;
  std::uint8_t buttons_ = 0;
};

}  // namespace platon::sim
