#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <span>
#include <vector>

#include "platon/game/game.h"
#include "platon/game/input.h"
#include "protocol/to_client.h"
#include "server/match/match_output.h"

namespace platon {

class MatchRoster;

/// The last decided ticks of a round: their input changes, and the hash of the game after each. They are sent to every
/// client until it acknowledges them.
class TickHistory {
 public:
  /// Ticks kept: 10 s. A client that is further behind needs a full state.
  static constexpr std::size_t kTicks = 600;

  /// A round without decided ticks; `hash` is the short hash of its game.
  TickHistory(std::uint32_t round, std::uint32_t hash) : round_(round), baseHash_(hash) {}

  /// Adds the next tick: its inputs by slot, and the short hash of the game after it.
  void append(std::span<const Input> inputs, std::uint32_t hash);

  /// Number of decided ticks.
  std::uint32_t end() const { return end_; }
  /// Whether all ticks from `confirmed` on are kept.
  bool covers(std::uint32_t confirmed) const { return confirmed <= end_ && confirmed >= end_ - entries_.size(); }
  /// Short hash of the game after `confirmed` ticks, which must be covered.
  std::uint32_t hashAfter(std::uint32_t confirmed) const;
  /// Sets `message` to the ticks from `confirmed` on, as many as fit, without link report. `confirmed` must be covered
  /// and before the end.
  void collect(std::uint32_t confirmed, ConfirmedTicks& message) const;
  /// Inputs of the last decided tick by slot; slots beyond its end are absent.
  const std::vector<Input>& held() const { return held_; }

 private:
  struct Entry {
    std::vector<InputChange> changes;
    std::uint32_t hash = 0;
  };

  const Entry& entry(std::uint32_t tick) const { return entries_[tick + entries_.size() - end_]; }

  std::uint32_t round_;
  std::uint32_t end_ = 0;
  std::uint32_t baseHash_;     // hash before the first entry
  std::deque<Entry> entries_;  // ticks end_ - size … end_ - 1
  std::vector<Input> held_;
};

/// How far one client has the decided ticks of the round, and which of them its next message holds.
class TickDelivery {
 public:
  /// A message that does not repeat all unacknowledged ticks has the last kRecentTicks, or more if they are sent so
  /// rarely that a tick would otherwise be in fewer than kRecentMessages messages.
  static constexpr std::uint32_t kRecentTicks = 8;
  static constexpr std::uint32_t kRecentMessages = 4;
  /// At least one message in this many begins with the first unacknowledged tick.
  static constexpr std::uint32_t kFullRepeatInterval = 4;

  /// Starts a round, of which the client has nothing. `started`: whether ticks are sent at once.
  void startRound(bool started);
  /// Ticks are sent from now on.
  void start() { started_ = true; }
  /// Whether ticks are sent to the client: in the round in which it joined, and in a later one once it has sent inputs.
  bool started() const { return started_; }

  void acknowledge(std::uint32_t confirmed) { acknowledged_ = confirmed; }
  /// Ticks of the round that the client has acknowledged.
  std::uint32_t acknowledged() const { return acknowledged_; }

  /// First tick of the next message of ticks, when `end` ticks are decided and a message is sent every `interval`
  /// ticks. After a message that could not hold all ticks: the tick at which it stopped. Otherwise, if none of the last
  /// kFullRepeatInterval - 1 messages has begun with it: the first unacknowledged tick. In the others: one of the last
  /// ticks, since with a long round trip most earlier ticks are not lost, only not acknowledged yet.
  std::uint32_t nextToSend(std::uint32_t end, std::uint32_t interval) const;
  /// Whether the last message of ticks could not hold all, and held so few that a message every `interval` ticks would
  /// hardly catch up.
  bool fallsBehind(std::uint32_t interval) const { return continueAt_ != 0 && lastTicks_ < 2 * interval; }
  /// Call when a message with the ticks from `from` to before `tick` was sent and `end` ticks were decided.
  void sent(std::uint32_t from, std::uint32_t tick, std::uint32_t end);
  /// Sequence number of the next message of ticks.
  std::uint8_t nextSequence() { return sequence_++; }

 private:
  std::uint8_t sequence_ = 0;
  std::uint32_t acknowledged_ = 0;
  std::uint32_t continueAt_ = 0;  // tick at which the last message of ticks stopped; 0: it held all
  std::uint32_t lastTicks_ = 0;   // ticks in the last message of ticks
  std::uint32_t messagesSinceFull_ = kFullRepeatInterval;  // since one that began with the first unacknowledged tick
  bool started_ = true;
};

/// What all clients of a match are told again and again: names that have changed, the decided ticks, and the round
/// trips of the players. The more players there are, the rarer are the messages, since each then costs more. Call the
/// functions once a tick, which is `now`, counted over all rounds.
class MatchUpdates {
 public:
  /// Each client is sent the decided ticks every tick while at most kFewPlayers are connected, every second tick while
  /// at most kManyPlayers are, and every third tick otherwise; and in every tick while a message holds too few of
  /// them.
  static constexpr std::size_t kFewPlayers = 4;
  static constexpr std::size_t kManyPlayers = 32;
  /// Fewest ticks between two messages about changed names: 0.25 s.
  static constexpr std::uint64_t kNamesTicks = kTicksPerSecond / 4;
  /// Ticks between two messages about the round trips of the players: 2 s.
  static constexpr std::uint64_t kRoundTripsTicks = 2 * kTicksPerSecond;

  void sendNames(MatchRoster& roster, std::uint64_t now, MatchOutput& output);
  void sendTicks(MatchRoster& roster, const TickHistory& history, std::uint64_t now, MatchOutput& output);
  /// `roundTrip`: to a client, milliseconds, and so of all its players. If it is empty, or a client is alone, nobody is
  /// told anything.
  static void sendRoundTrips(const MatchRoster& roster, const std::function<std::uint32_t(ClientId)>& roundTrip,
                             std::uint64_t now, MatchOutput& output);

 private:
  std::uint64_t nextNamesAt_ = 0;
  ConfirmedTicks ticks_;  // the last ones sent
};

}  // namespace platon
