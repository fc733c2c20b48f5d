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
#include "server/match/input_buffer.h"
#include "server/match/transfer.h"

namespace platon {

/// A client that has a slot: its inputs, how far it has followed the round, and what is on its way to it.
class MatchPlayer {
 public:
  /// Level texts that a client may ask for in one round.
  static constexpr std::uint32_t kRequestsPerRound = 8;
  /// Ticks between two full states: a client that never agrees costs one a second.
  static constexpr std::uint64_t kTicksBetweenStates = 60;

  static constexpr std::uint32_t kRecentTicks = 8;
  static constexpr std::uint8_t kWholeEvery = 4;  // of which 256 is a multiple

  MatchPlayer(std::uint32_t slot, std::string name, const std::optional<SessionToken>& token)
      : slot_(slot), name_(std::move(name)), token_(token) {}

  std::uint32_t slot() const { return slot_; }
  const std::string& name() const { return name_; }
  /// Whether it was greeted with this token.
  bool has(const SessionToken& token) const { return token_ && sameToken(*token_, token); }
  /// Where its client connects from, as Match is told.
  std::uint32_t origin() const { return origin_; }
  void setOrigin(std::uint32_t origin) { origin_ = origin; }
  /// Whether anybody could take it up.
  bool canBeTakenUp() const { return token_.has_value(); }

  /// The player is taken up by another client, which knows nothing of what was sent.
  void takeUp(std::string name);

  /// A new round begins; what was on its way from the old one is pointless.
  void startRound();

  /// A message of inputs has come, of whatever round.
  void hear(std::uint8_t sequence);
  /// Takes the inputs of a message of the current round, of which `decided` ticks are decided.
  void take(const PlayerInputs& message, std::uint32_t decided);
  /// Whether the message tells how far the client really is: it has the last state sent, and is not overtaken.
  bool isCurrent(const PlayerInputs& message) const;
  void acknowledge(std::uint32_t confirmed) { acknowledged_ = confirmed; }

  /// Whether the client follows the round: from when it joined, or in later rounds has said so.
  bool started() const { return started_; }
  /// Ticks of the round that the client is known to have.
  std::uint32_t acknowledged() const { return acknowledged_; }
  /// Where the next message of ticks starts, of which `end` are decided: where the last one ended when not all fitted
  /// in, else, in every kWholeEvery-th message, at the first tick that is not acknowledged. The others repeat only the
  /// last kRecentTicks: on a long line the rest is mostly not lost but on its way.
  std::uint32_t nextPart(std::uint32_t end) const;
  /// A message of ticks ended at `tick`, when `end` were decided.
  void sentUpTo(std::uint32_t tick, std::uint32_t end) { rest_ = tick < end ? tick : 0; }
  /// What was heard since the last call.
  std::optional<LinkReport> takeLine();
  /// The number of the next message of ticks.
  std::uint8_t nextSequence() { return sequence_++; }

  /// The input of the player for the next tick.
  Input decide() { return inputs_.take(); }
  std::uint64_t missedInputs() const { return inputs_.missed(); }
  /// Ticks of the round before this one are decided without this player.
  void joinAt(std::uint32_t tick) { inputs_ = InputBuffer(tick); }

  /// Puts a level text on its way, unless it is already or the client has asked too often.
  void sendLevel(const LevelPointer& level);
  /// Whether a state may be sent at this tick of the match, counted over all rounds.
  bool mayTakeState(std::uint64_t now) const { return now >= nextState_; }
  /// Puts a full state, after `tick` ticks of the round, on its way.
  void sendState(std::uint32_t round, std::uint32_t tick, std::vector<std::uint8_t> state, std::uint64_t now);
  /// The next piece on its way; nothing when there is none.
  std::optional<std::vector<std::uint8_t>> nextPiece();

 private:
  void forget();
  void judge(const PlayerInputs& message, std::uint32_t decided);
  std::uint32_t judgedTick(const PlayerInputs& message) const;

  std::uint32_t slot_;
  std::string name_;
  std::optional<SessionToken> token_;
  std::uint32_t origin_ = 0;
  InputBuffer inputs_;
  std::deque<Transfer> transfers_;
  LossMeter heard_;
  std::optional<LinkReport> line_;
  std::uint32_t newTick_ = 0;  // of this and all later ticks of the round no input has come
  Input lastInput_;            // of the tick before
  std::uint8_t sequence_ = 0;
  std::uint32_t acknowledged_ = 0;
  std::uint32_t rest_ = 0;  // start of what did not fit in the last message of ticks
  std::uint32_t requests_ = 0;
  std::uint64_t nextState_ = 0;
  std::uint8_t sync_ = 0;  // of the last state sent in this round
  bool started_ = true;
};

}  // namespace platon
