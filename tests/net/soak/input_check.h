#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "protocol/to_server.h"

namespace platon {

/// Compares the buttons that a client sends for each tick with those that the server decides, whichever comes first.
class InputCheck {
 public:
  /// Call when the client sends a message.
  void sent(const PlayerInputs& message) {
    for (std::size_t i = 0; i < message.inputs.size(); ++i) {
      const std::uint32_t tick = message.first + static_cast<std::uint32_t>(i);
      sent_[tick % kTicks] = {message.round, tick, buttonsOf(message.inputs[i].buttons)};
    }
  }

  /// Call when the server has decided a tick. Returns whether the buttons of the tick kDelay before it, if they were
  /// sent, were others.
  bool decided(std::uint32_t round, std::uint32_t tick, std::uint8_t buttons) {
    decided_[tick % kTicks] = {round, tick, buttonsOf(buttons)};
    const Buttons& past = decided_[(tick - kDelay) % kTicks];
    const Buttons& sent = sent_[(tick - kDelay) % kTicks];
    return past.round == round && past.tick == tick - kDelay && past.isOfTick(sent) && past.buttons != sent.buttons;
  }

 private:
  static constexpr std::uint32_t kTicks = 512;
  static constexpr std::uint32_t kDelay = 128;  // within which the client has sent the input of a tick

  struct Buttons {
    std::uint32_t round = 0;  // 0: none
    std::uint32_t tick = 0;
    std::uint8_t buttons = 0;

    bool isOfTick(const Buttons& other) const { return round == other.round && tick == other.tick; }
  };

  static std::uint8_t buttonsOf(std::uint8_t input) { return input & static_cast<std::uint8_t>(Input::kPresent - 1); }

  std::array<Buttons, kTicks> sent_{};
  std::array<Buttons, kTicks> decided_{};
};

}  // namespace platon
