#pragma once

#include <chrono>
#include <optional>

#include "client/ui/key.h"

namespace platon {

/// Repeats the direction of the gamepad that is held, as keyboards repeat their keys.
class PadRepeat {
 public:
  using Time = std::chrono::microseconds;  ///< of a monotonic clock

  static constexpr Time kDelay = std::chrono::milliseconds(400);    ///< from the press to the first repetition
  static constexpr Time kInterval = std::chrono::milliseconds(80);  ///< between two of them

  /// Call with each event.
  void observe(const KeyEvent& event, Time now);
  /// The repetition of the direction that was pressed last, if it is due. A direction that is not repeated now, such as
  /// one that moves the ball, is repeated only after it is pressed again.
  std::optional<KeyEvent> repeat(bool repeats, Time now);

 private:
  std::optional<Key> held_;
  Time next_{};  // when held_ is repeated
};

}  // namespace platon
