#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "platon/game/input.h"

namespace platon {

/// Inputs of one player in one round, from their arrival until the server decides their tick. Ticks are decided in
/// order, one by one, whether or not their input has arrived.
class InputBuffer {
 public:
  /// Ticks for which inputs are accepted, from the next one to decide: about 2 s.
  static constexpr std::uint32_t kWindow = 128;
  /// Ticks without an input after which buttons count as released: 1 s.
  static constexpr std::uint32_t kHoldTicks = 60;

  /// `next` is the first tick to decide. The player is absent until its first input.
  explicit InputBuffer(std::uint32_t next = 0) : next_(next) {}

  /// Stores the input of a tick. False if the tick is decided, beyond the window, or already has an input; nothing
  /// changes then.
  bool add(std::uint32_t tick, Input input);

  /// Discards the inputs of undecided ticks. The last decided input stays in effect.
  void clear() { waiting_.fill(std::nullopt); }

  /// Decides tick `next()`: the input that arrived for it, otherwise the last decided one.
  Input decide();

  std::uint32_t next() const { return next_; }
  /// Ticks decided without their input since the player appeared.
  std::uint64_t missed() const { return missed_; }

 private:
  std::optional<Input>& at(std::uint32_t tick) { return waiting_[tick % kWindow]; }

  std::array<std::optional<Input>, kWindow> waiting_{};  // ticks next_ … next_ + kWindow - 1
  std::uint32_t next_;
  Input last_;                           // decided last; absent until the first input
  std::uint32_t ticksWithoutInput_ = 0;  // since the last input
  std::uint64_t missed_ = 0;
};

}  // namespace platon
