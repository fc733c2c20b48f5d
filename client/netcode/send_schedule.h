#pragma once

#include <cstdint>
#include <optional>

#include "platon/game/input.h"
#include "protocol/moment.h"

namespace platon {

/// Decides when the client sends its inputs: at once when they change, and again one and two ticks later; otherwise
/// every fourth tick. While there are no new inputs, every 80 ms.
class SendSchedule {
 public:
  /// Adds the local player's input for the next tick.
  void addInput(Input input);
  /// Makes a message due at once.
  void sendSoon() { urgent_ = true; }

  /// Whether a message with the inputs before tick `end` is due.
  bool due(Moment now, std::uint32_t end) const;
  /// Call when a message with the inputs before tick `end` has been sent.
  void sent(Moment now, std::uint32_t end);

 private:
  std::optional<Moment> sentAt_;
  std::uint32_t sentEnd_ = 0;
  Input last_;
  bool hasNew_ = false;        // inputs were added since the last message
  bool changed_ = false;       // and one of them differed from its predecessor
  std::uint32_t repeats_ = 0;  // remaining repetitions of the last change
  bool urgent_ = false;
};

}  // namespace platon
