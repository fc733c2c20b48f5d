#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "client/netcode/link_meter.h"
#include "protocol/time.h"
#include "protocol/to_client.h"
#include "protocol/to_server.h"

namespace platon {

/// An encoded message to the server.
struct OutgoingMessage {
  std::vector<std::uint8_t> bytes;
  bool reliable = false;  ///< reliable channel if true, else unsequenced on the tick channel
};

/// Why a session has ended.
struct SessionEnding {
  std::string reason;      ///< one sentence for the player
  bool permanent = false;  ///< reconnecting would fail too
  std::string next{};      ///< where the player can go on (isNextServer), perhaps empty
};

/// The part of a session that does not depend on what is played: it says Hello, keeps Welcome and why the session has
/// ended, queues messages to the server, and measures the connection.
class Dialogue {
 public:
  /// Queues `hello`. `now`: when the connection was established.
  Dialogue(const Hello& hello, Time now);

  /// The message in these bytes. Malformed bytes end the session.
  std::optional<ToClient> receive(std::span<const std::uint8_t> bytes, Time now);
  /// Keeps Welcome. Returns the initial lead of the first round; nothing for a second Welcome, which ends the session.
  std::optional<double> begin(const Welcome& message, Time now);
  void end(const Refused& message);
  void end(const Bye& message);
  void end(SessionEnding ending) { ending_ = std::move(ending); }
  /// Measures the connection by a message of any round.
  void measure(const ConfirmedTicks& message, Time now) { linkMeter_.receive(message, now); }

  void send(const auto& message, bool reliable) { outgoing_.push_back({encode(message), reliable}); }
  /// Sends inputs under the next sequence number.
  void sendInputs(PlayerInputs message, Time now);
  /// Queued messages, oldest first; each is returned once.
  std::vector<OutgoingMessage> takeOutgoing() { return std::exchange(outgoing_, {}); }

  /// Slot and server name; empty until the server has accepted the client.
  const std::optional<Welcome>& welcome() const { return welcome_; }
  /// Empty while the session runs.
  const std::optional<SessionEnding>& ending() const { return ending_; }
  /// When the last message was received.
  Time receivedAt() const { return receivedAt_; }
  /// `clock`: of the present round; null: none.
  LinkStatistics linkStatistics(const PredictionClock* clock) const { return linkMeter_.statistics(clock); }

 private:
  void endAsTold(const char* what, const std::string& why, bool permanent, const std::string& next);

  Time helloAt_;
  Time receivedAt_;
  std::optional<Welcome> welcome_;
  std::optional<SessionEnding> ending_;
  std::vector<OutgoingMessage> outgoing_;
  LinkMeter linkMeter_;
};

}  // namespace platon
