#pragma once

#include <cstdint>
#include <random>

#include "platon/game/input.h"

namespace platon {

/// Generates random inputs like those of a player: the held buttons change three to six times a second. The same seed
/// gives the same inputs on every platform.
class ButtonPresser {
 public:
  explicit ButtonPresser(std::uint64_t seed) : random_(seed) {}

  /// Input for the next tick.
  Input next();

 private:
  std::uint32_t below(std::uint32_t limit) { return static_cast<std::uint32_t>(random_() % limit); }
  std::uint8_t otherButtons();

  std::mt19937_64 random_;
  std::uint32_t ticksLeft_ = 0;
  std::uint8_t held_ = 0;
};

}  // namespace platon
