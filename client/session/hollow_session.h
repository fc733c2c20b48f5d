#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "client/netcode/input_sender.h"
#include "client/netcode/link_meter.h"
#include "client/netcode/prediction_clock.h"
#include "client/session/outgoing_message.h"
#include "protocol/assembly.h"
#include "protocol/moment.h"
#include "protocol/session_token.h"
#include "protocol/to_client.h"

namespace platon {

/// A session without a game, for loading a server with many players at little cost. It joins, sends inputs in time and
/// acknowledges confirmed ticks with the hash that the server sent, so the server treats it like any other player. It
/// never detects a desync, and does not download the levels of later rounds.
class HollowSession {
 public:
  /// Returns the input for the next tick.
  using Buttons = std::function<Input()>;

  /// `name`, `now`: as for Session. `token`: identifies the player to resume; without one it cannot be resumed.
  HollowSession(const std::string& name, Moment now, const std::optional<SessionToken>& token = {});
  void receive(std::span<const std::uint8_t> bytes, Moment now);
  void update(Moment now, const Buttons& buttons);
  void leave();
  std::vector<OutgoingMessage> takeOutgoing() { return std::exchange(outgoing_, {}); }
  /// Why the session has ended; empty while it runs.
  const std::optional<std::string>& ending() const { return ending_; }

  /// Local slot and server name; empty until the server has accepted the client.
  const std::optional<Welcome>& welcome() const { return welcome_; }
  /// Confirmed ticks of all rounds.
  std::uint32_t confirmedTicks() const { return confirmedTicks_; }
  LinkStatistics linkStatistics() const;

 private:
  // A round without a game.
  struct Round {
    Round(std::uint32_t roundId, double lead) : id(roundId), clock(lead), sender(roundId) {}

    std::uint32_t id;
    PredictionClock clock;
    InputSender sender;
    ConfirmedState confirmed;
    std::uint8_t sync = 0;
    std::uint32_t next = 0;  // first tick without an input
  };

  template <class Message>
  void handle(const Message&, Moment) {}
  void handle(const Welcome& message, Moment now);
  void handle(const Refused& message, Moment now);
  void handle(const LevelChunk& message, Moment now);
  void handle(const StateChunk& message, Moment now);
  void handle(const RoundStart& message, Moment now);
  void handle(const Bye& message, Moment now);
  void handle(const ConfirmedTicks& message, Moment now);

  void startRound(std::uint32_t id, double lead);
  void chooseInputs(Moment now, const Buttons& buttons);

  Moment helloAt_;
  std::optional<std::string> ending_;
  std::optional<Welcome> welcome_;
  std::vector<OutgoingMessage> outgoing_;
  LinkMeter linkMeter_;
  Assembly levelText_;
  Assembly state_;
  bool hasLevel_ = false;
  Round round_{0, 0};
  std::uint32_t confirmedTicks_ = 0;
};

}  // namespace platon
