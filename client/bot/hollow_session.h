#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "client/session/dialogue.h"
#include "client/session/round.h"
#include "protocol/session_token.h"
#include "protocol/time.h"
#include "protocol/to_client.h"
#include "protocol/transfer.h"

namespace platon {

/// A session without a game, for loading a server with many players at little cost: Dialogue and RoundExchange are
/// those of a Session, and the hash of each confirmed tick is the one that the server sent, so the server treats it
/// like any other player. It never detects a desync, and does not download the levels of later rounds.
class HollowSession {
 public:
  /// Returns the input for the next tick.
  using Buttons = std::function<Input()>;

  /// `name`, `now`: as for Session. `token`: identifies the player to resume; without one it cannot be resumed.
  HollowSession(const std::string& name, Time now, const std::optional<SessionToken>& token = {})
      : dialogue_({kRulesVersion, name, token}, now) {}

  void receive(std::span<const std::uint8_t> bytes, Time now);
  void update(Time now, const Buttons& buttons);
  void leave();
  std::vector<OutgoingMessage> takeOutgoing() { return dialogue_.takeOutgoing(); }

  /// Why the session has ended; empty while it runs.
  const std::optional<SessionEnding>& ending() const { return dialogue_.ending(); }
  /// Local slot and server name; empty until the server has accepted the client.
  const std::optional<Welcome>& welcome() const { return dialogue_.welcome(); }
  /// Confirmed ticks of all rounds.
  std::uint32_t confirmedTicks() const { return confirmedTicks_; }
  LinkStatistics linkStatistics() const { return dialogue_.linkStatistics(exchange_ ? &exchange_->clock() : nullptr); }

 private:
  template <class Message>
  void handle(const Message&, Time) {}
  void handle(const Welcome& message, Time now);
  void handle(const Refused& message, Time) { dialogue_.end(message); }
  void handle(const Bye& message, Time) { dialogue_.end(message); }
  void handle(const LevelChunk& message, Time now);
  void handle(const RoundStart& message, Time now);
  void handle(const StateChunk& message, Time now);
  void handle(const ConfirmedTicks& message, Time now);
  void startRound(std::uint32_t id, double lead);

  Dialogue dialogue_;
  Assembly levelText_;
  bool hasLevel_ = false;
  std::optional<RoundExchange> exchange_;  // of the present round; empty before Welcome
  ConfirmedState confirmed_;
  std::uint8_t sync_ = 0;   // of the last full state
  std::uint32_t next_ = 0;  // first tick without an input
  std::uint32_t confirmedTicks_ = 0;
};

}  // namespace platon
