#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "platon/game/input.h"
#include "protocol/time.h"
#include "protocol/to_server.h"

namespace platon {

/// Inputs by local number, as SlotsByLocal; not present for a local number without a player.
using InputsByLocal = std::array<Input, kMaxLocalPlayers>;

/// Decides when the client sends its inputs: at once when they change, and again one and two ticks later; otherwise
/// every fourth tick. While there are no new inputs, every 80 ms.
class SendSchedule {
 public:
  /// Adds the inputs of the local players for the next tick.
  void addInputs(const InputsByLocal& inputs);
  /// Makes a message due at once.
  void sendSoon() { urgent_ = true; }

  /// Whether a message with the inputs before tick `end` is due.
  bool due(Time now, std::uint32_t end) const;
  /// Call when a message with the inputs before tick `end` has been sent.
  void sent(Time now, std::uint32_t end);

 private:
  std::optional<Time> sentAt_;
  std::uint32_t sentEnd_ = 0;
  InputsByLocal last_{};
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

/// Sends the inputs of the local players in one round. Every message repeats all inputs that the server has not
/// confirmed.
class InputSender {
 public:
  explicit InputSender(std::uint32_t round) : round_(round) {}

  /// Adds the inputs for `tick`. Ticks increase from call to call; skipped ticks must already be confirmed. The first
  /// player is always present; a companion that is not has left, and what it has added is not sent any more.
  void add(std::uint32_t tick, const InputsByLocal& inputs);
  /// Another player has this local number now: what was added for the one before is not sent any more.
  void forget(std::size_t local) { firsts_[local].reset(); }
  /// Makes the next message due at once.
  void sendSoon() { schedule_.sendSoon(); }

  /// Returns the message to send at `now`, without its sequence number; nothing if none is due. At most
  /// kMaxInputsPerMessage inputs, the oldest first.
  std::optional<PlayerInputs> takeMessage(Time now, const ConfirmedState& confirmed);

 private:
  std::vector<Input> inputsOf(std::size_t local, std::uint32_t first, std::uint32_t end) const;

  std::uint32_t round_;
  SendSchedule schedule_;
  std::array<std::optional<std::uint32_t>, kMaxLocalPlayers> firsts_;  // first ticks; a player is absent before its own
  std::uint32_t end_ = 0;                                              // one past the last tick added
  std::array<InputsByLocal, kMaxInputsPerMessage> inputs_{};           // by tick modulo its size
};

}  // namespace platon
