#pragma once

#include <chrono>
#include <optional>
#include <vector>

#include "client/ui/key.h"

namespace platon {

/// Repeats the direction of the gamepad that is held, as keyboards repeat their keys.
class PadRepeat {
 public:
  using Time = std::chrono::microseconds;  ///< of a monotonic clock

  static constexpr Time kDelay = std::chrono::milliseconds(400);    ///< from the press to the first repetition
  static constexpr Time kInterval = std::chrono::milliseconds(80);  ///< between two of them

  /// `events` are those since the last call. Returns them and, after them, at most one repetition of the direction that
  /// was pressed last. A direction that is not repeated `now`, such as one that moves the ball, is repeated only after
  /// it is pressed again.
  std::vector<KeyEvent> withRepeats(std::vector<KeyEvent> events, bool repeats, Time now);

 private:
  void observe(const KeyEvent& event, Time now);

  std::optional<Key> held_;
  Time next_{};  // when held_ is repeated
};

}  // namespace platon
