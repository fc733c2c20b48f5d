#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "platon/game/input.h"
#include "protocol/time.h"
#include "protocol/to_server.h"

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
  bool due(Time now, std::uint32_t end) const;
  /// Call when a message with the inputs before tick `end` has been sent.
  void sent(Time now, std::uint32_t end);

 private:
  std::optional<Time> sentAt_;
  std::uint32_t sentEnd_ = 0;
  Input last_;
  bool hasNew_ = false;        // inputs were added since the last message
  bool changed_ = false;       // and one of them differed from its predecessor
  std::uint32_t repeats_ = 0;  // remaining repetitions of the last change
  bool urgent_ = false;
};

/// Progress of the client's confirmed game, reported in every PlayerInputs message.
struct ConfirmedState {
  std::uint32_t ticks = 0;  ///< confirmed ticks of the round
  std::uint32_t hash = 0;   ///< `shortHash` of the confirmed game
  std::uint8_t sync = 0;    ///< of the last full state taken in this round; 0: none
};

/// Sends the local player's inputs of one round. Every message repeats all inputs that the server has not confirmed.
class InputSender {
 public:
  explicit InputSender(std::uint32_t round) : round_(round) {}

  /// Adds the local input for `tick`. Ticks increase from call to call; skipped ticks must already be confirmed.
  void add(std::uint32_t tick, Input input);
  /// Makes the next message due at once.
  void sendSoon() { schedule_.sendSoon(); }

  /// Returns the message to send at `now`, without its sequence number; nothing if none is due. At most
  /// kMaxInputsPerMessage inputs, the oldest first.
  std::optional<PlayerInputs> takeMessage(Time now, const ConfirmedState& confirmed);

 private:
  std::uint32_t round_;
  SendSchedule schedule_;
  std::optional<std::uint32_t> first_;                // first tick added; the local player is absent before it
  std::uint32_t end_ = 0;                             // one past the last tick added
  std::array<Input, kMaxInputsPerMessage> inputs_{};  // by tick modulo its size
};

}  // namespace platon
