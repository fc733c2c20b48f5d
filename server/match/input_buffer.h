#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "platon/game/input.h"

namespace platon {

/// The inputs of one player of one round, from their arrival until their tick is decided. Ticks are decided in order,
/// one by one, whether or not their input has come.
class InputBuffer {
 public:
  /// Ticks ahead of the next one that are taken: 2 s.
  static constexpr std::uint32_t kWindow = 128;
  /// Ticks without any input after which buttons count as released: 1 s.
  static constexpr std::uint32_t kHoldTicks = 60;

  /// `next` is the first tick to decide. Until the first input has come the player is absent.
  explicit InputBuffer(std::uint32_t next = 0) : next_(next) {}

  /// False, and nothing is changed, when the tick is decided, too far ahead, or known.
  bool add(std::uint32_t tick, Input input);

  /// Forgets what came for ticks that are not decided: the client begins anew. The player stays as it is.
  void clear() { waiting_.fill(std::nullopt); }

  /// Decides tick `next()`: the input that came for it, else the last one held.
  Input take();

  std::uint32_t next() const { return next_; }
  /// Ticks decided without their input since the player appeared.
  std::uint64_t missed() const { return missed_; }

 private:
  std::optional<Input>& at(std::uint32_t tick) { return waiting_[tick % kWindow]; }

  std::array<std::optional<Input>, kWindow> waiting_{};  // of ticks next_ … next_ + kWindow - 1
  std::uint32_t next_;
  Input held_;                 // absent until the first input
  std::uint32_t silence_ = 0;  // ticks decided since the last input
  std::uint64_t missed_ = 0;
};

}  // namespace platon
