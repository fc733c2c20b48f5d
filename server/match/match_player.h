#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "protocol/loss_meter.h"
#include "protocol/session_token.h"
#include "protocol/to_client.h"
#include "protocol/to_server.h"
#include "protocol/transport/socket_address.h"
#include "server/match/chat_budget.h"
#include "server/match/input_buffer.h"
#include "server/match/transfer.h"
#include "server/match/vote_wish.h"

namespace platon {

/// A player of the match and what the server knows of its client: inputs, acknowledged ticks, transfers in progress.
class MatchPlayer {
 public:
  /// Level texts that a client may request in one round.
  static constexpr std::uint32_t kMaxLevelsPerRound = 8;
  /// Ticks without a changed button after which a player is inactive: 60 s.
  static constexpr std::uint64_t kActiveTicks = 60 * kTicksPerSecond;
  /// Minimum number of ticks between two full states: a client in permanent desync gets one a second.
  static constexpr std::uint64_t kTicksBetweenStates = 60;

  /// A message that does not repeat all unacknowledged ticks has the last kRecentTicks, or more if they are sent so
  /// rarely that a tick would otherwise be in fewer than kRecentMessages messages.
  static constexpr std::uint32_t kRecentTicks = 8;
  static constexpr std::uint32_t kRecentMessages = 4;
  /// At least one message in this many begins with the first unacknowledged tick.
  static constexpr std::uint32_t kFullRepeatInterval = 4;

  /// A player that joins at tick `now` of the match, counted over all rounds.
  MatchPlayer(std::uint32_t slot, std::string name, const std::optional<SessionToken>& token, std::uint64_t now)
      : slot_(slot), name_(std::move(name)), token_(token), activeAt_(now) {}

  std::uint32_t slot() const { return slot_; }
  const std::string& name() const { return name_; }
  /// Whether the player joined with this token.
  bool hasToken(const SessionToken& token) const { return token_ && sameToken(*token_, token); }
  /// Address that the client is at, or was at last.
  const IpAddress& address() const { return address_; }
  /// Household of this address.
  std::uint64_t origin() const { return origin_; }
  void setAddress(const IpAddress& address) {
    address_ = address;
    origin_ = address.household();
  }
  /// Whether a client can resume the player, that is, whether it joined with a token.
  bool canResume() const { return token_.has_value(); }

  /// Resumes the player for another client. That client has received nothing that was sent to the previous one.
  void resume(std::string name);

  /// Starts a new round. A transfer of a state of the old round is cancelled.
  void startRound();

  /// Counts a message of inputs, of any round, for the link report.
  void countMessage(std::uint8_t sequence);
  /// Stores the inputs of a message of the current round. `decided`: number of decided ticks of the round; `now`: tick
  /// of the match.
  void addInputs(const PlayerInputs& message, std::uint32_t decided, std::uint64_t now);
  /// Whether the client has changed a button, voted or joined in the last kActiveTicks. A button that is held for
  /// longer does not count, nor does the release of buttons for want of inputs.
  bool isActive(std::uint64_t now) const { return now - activeAt_ < kActiveTicks; }
  /// The player wishes the next level, or no longer wishes it. The wish ends with the round and with the connection.
  void vote(bool next, std::uint64_t now);
  /// Whether this wish counts now (VoteWish).
  bool wishesNext(std::uint64_t now) { return wish_.counts(now); }
  /// Whether the player may say something more at tick `now` of the match; it counts then.
  bool mayChat(std::uint64_t now) { return chatBudget_.take(now); }
  /// Whether the message reports the client's current progress: the client has restored the last state sent, and the
  /// message is not older than another one received.
  bool isCurrent(const PlayerInputs& message) const;
  void acknowledge(std::uint32_t confirmed) { acknowledged_ = confirmed; }

  /// Whether ticks are sent to the client: in the round in which it joined, and in a later one once it has sent inputs.
  bool started() const { return started_; }
  /// Ticks of the round that the client has acknowledged.
  std::uint32_t acknowledged() const { return acknowledged_; }
  /// First tick of the next message of ticks, when `end` ticks are decided and a message is sent every `interval`
  /// ticks. After a message that could not hold all ticks: the tick at which it stopped. Otherwise, if none of the last
  /// kFullRepeatInterval - 1 messages has begun with it: the first unacknowledged tick. In the others: one of the last
  /// ticks, since with a long round trip most earlier ticks are not lost, only not acknowledged yet.
  std::uint32_t nextTickToSend(std::uint32_t end, std::uint32_t interval) const;
  /// Whether the last message of ticks could not hold all, and held so few that a message every `interval` ticks would
  /// hardly catch up.
  bool fallsBehind(std::uint32_t interval) const { return continueAt_ != 0 && lastTicks_ < 2 * interval; }
  /// Call when a message with the ticks from `from` to before `tick` was sent and `end` ticks were decided.
  void ticksSent(std::uint32_t from, std::uint32_t tick, std::uint32_t end);
  /// Link report since the last call; nothing if no message of inputs has arrived.
  std::optional<LinkReport> takeLinkReport();
  /// Sequence number of the next message of ticks.
  std::uint8_t nextSequence() { return sequence_++; }

  /// Decides the input of the player for the next tick.
  Input decideInput() { return inputs_.decide(); }
  std::uint64_t missedInputs() const { return inputs_.missed(); }
  /// Lets the player join: ticks of the round before `tick` are decided without it.
  void joinAt(std::uint32_t tick) { inputs_ = InputBuffer(tick); }

  /// Starts this transfer of a level text, unless one is in progress or the client has requested too many.
  void sendLevel(Transfer level);
  /// Whether a full state may be sent at this tick of the match, counted over all rounds.
  bool maySendState(std::uint64_t now) const { return now >= nextStateAt_; }
  /// Number of the next full state in the round.
  std::uint8_t nextSync() const { return sync_ == UINT8_MAX ? 1 : static_cast<std::uint8_t>(sync_ + 1); }
  /// Starts this transfer of a full state after `tick` ticks of the round. Its number is nextSync().
  void sendState(Transfer state, std::uint32_t tick, std::uint64_t now);
  /// The next message of the transfers in progress; nothing if there are none.
  std::optional<SharedBytes> nextChunk();
  bool hasChunks() const { return !transfers_.empty(); }

 private:
  void resetProgress();
  void measureSlack(const PlayerInputs& message, std::uint32_t decided);
  void noteButtons(const PlayerInputs& message, std::uint64_t now);
  std::uint32_t measuredTick(const PlayerInputs& message) const;

  std::uint32_t slot_;
  std::string name_;
  std::optional<SessionToken> token_;
  IpAddress address_;
  std::uint64_t origin_ = 0;
  std::uint64_t activeAt_;    // tick of the match in which the client last changed a button, voted or joined
  std::uint8_t buttons_ = 0;  // of the newest input of all rounds
  VoteWish wish_;
  ChatBudget chatBudget_ = ChatBudget::ofPlayers(1);
  InputBuffer inputs_;
  std::deque<Transfer> transfers_;
  LossMeter loss_;  // of the messages of inputs
  std::optional<LinkReport> linkReport_;
  std::uint32_t inputsEnd_ = 0;  // one past the newest tick of the round for which an input has arrived
  Input newestInput_;            // for tick inputsEnd_ - 1
  std::uint8_t sequence_ = 0;
  std::uint32_t acknowledged_ = 0;
  std::uint32_t continueAt_ = 0;  // tick at which the last message of ticks stopped; 0: it held all
  std::uint32_t lastTicks_ = 0;   // ticks in the last message of ticks
  std::uint32_t messagesSinceFull_ = kFullRepeatInterval;  // since one that began with the first unacknowledged tick
  std::uint32_t levelRequests_ = 0;
  std::uint64_t nextStateAt_ = 0;
  std::uint8_t sync_ = 0;  // number of the last state sent in this round
  bool started_ = true;
};

}  // namespace platon
