#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "platon/game/game.h"
#include "protocol/limits.h"
#include "protocol/loss_meter.h"
#include "protocol/session_token.h"
#include "protocol/to_client.h"
#include "protocol/to_server.h"
#include "protocol/transport/socket_address.h"
#include "server/match/match_player.h"
#include "server/match/tick_budget.h"
#include "server/match/transfers.h"
#include "server/match/updates.h"

namespace platon {

/// How well the messages of inputs of a client arrive: what is lost, and how early the rest comes.
class InputArrival {
 public:
  /// Counts a message of inputs, of any round.
  void count(std::uint8_t sequence);
  /// An input of one of the players came so early. Of all since the last report, the smallest slack is reported.
  void note(const SlackReport& slack);
  /// Nothing has arrived of the round that starts.
  void startRound() { report_.reset(); }
  /// The report since the last call; nothing if no message of inputs has arrived.
  std::optional<LinkReport> take();

 private:
  LossMeter loss_;
  std::optional<LinkReport> report_;
};

/// Whether a client wishes the next level. It may change its mind at any time. What counts follows its last wish, but
/// changes at most once in kMinTicks, so that a flood of votes does not make the counts of others flicker.
class VoteWish {
 public:
  static constexpr std::uint64_t kMinTicks = kTicksPerSecond;

  void set(bool next) { last_ = next; }
  /// No wish, from now on.
  void clear() { last_ = counts_ = false; }
  /// Whether the wish counts at tick `now` of the match, which never decreases.
  bool counts(std::uint64_t now) {
    if (last_ != counts_ && now >= changeableAt_) {
      counts_ = last_;
      changeableAt_ = now + kMinTicks;
    }
    return counts_;
  }

 private:
  bool last_ = false;
  bool counts_ = false;
  std::uint64_t changeableAt_ = 0;
};

/// A client of the match, one connection at a time: who it is and where, its one to kMaxLocalPlayers players, how its
/// messages arrive, its wish for the next level, the ticks that it has, the transfers to it. It may lose its
/// connection; another client can resume all its players then.
class MatchClient {
 public:
  /// How often a client may add and rename companions: so often at once, and then one more every 2 s.
  static constexpr double kCompanionBurst = 4;
  static constexpr double kCompanionsPerSecond = 0.5;

  /// `first`: the player of Hello, whose local number is 0.
  MatchClient(const std::optional<SessionToken>& token, MatchPlayer first);

  /// Whether the client joined with this token.
  bool hasToken(const SessionToken& token) const { return token_ && sameToken(*token_, token); }
  /// Whether another client can resume the players, that is, whether this one joined with a token.
  bool canResume() const { return token_.has_value(); }
  /// Address that the client is at, or was at last.
  const IpAddress& address() const { return address_; }
  /// Household of this address.
  std::uint64_t origin() const { return address_.household(); }
  void setAddress(const IpAddress& address) { address_ = address; }

  /// Its players by local number.
  std::map<std::uint32_t, MatchPlayer>& players() { return players_; }
  const std::map<std::uint32_t, MatchPlayer>& players() const { return players_; }
  /// The player of Hello.
  MatchPlayer& first() { return players_.at(0); }
  const MatchPlayer& first() const { return players_.at(0); }
  /// The player with this local number; null if there is none.
  MatchPlayer* player(std::uint32_t local);
  const MatchPlayer* player(std::uint32_t local) const;
  /// The local number of the player in this slot; nothing if it is of another client.
  std::optional<std::uint32_t> localIn(std::uint32_t slot) const;
  /// The slots of its players, as in LocalSlots.
  SlotsByLocal slots() const;
  /// Number of its players that are active at tick `now` of the match.
  std::uint32_t activePlayers(std::uint64_t now) const;

  /// Whether the client may add or rename a companion at tick `now` of the match; it counts then.
  bool mayChangeCompanion(std::uint64_t now) { return companionBudget_.take(now); }
  /// Whether to answer a wish about a companion that changes nothing: once a tick for each local number.
  bool shouldAnswer(std::uint32_t local, std::uint64_t now) {
    return std::exchange(answeredAt_[local < kMaxLocalPlayers ? local : 0], now) != now;
  }
  /// Whether the client may have further companions: until one of them was kicked, or that one would be back at once.
  bool mayAddCompanions() const { return mayAddCompanions_; }
  void forbidCompanions() { mayAddCompanions_ = false; }
  /// Whether further companions are muted: once a muted one has left, which would be heard again at once.
  bool mutesCompanions() const { return mutesCompanions_; }
  void muteCompanions() { mutesCompanions_ = true; }

  /// Another client resumes the players. It has received nothing that was sent to the previous one.
  void resume();
  /// Starts a new round. A transfer of a state of the old round is cancelled.
  void startRound();

  /// Stores the inputs of a message of the current round, each for its player; those for a player that is not there are
  /// ignored. `decided`: number of decided ticks of the round; `now`: tick of the match. Returns how many of the inputs
  /// are missed ones (InputBuffer::missed).
  std::uint64_t addInputs(const PlayerInputs& message, std::uint32_t decided, std::uint64_t now);
  /// Whether the message reports the client's current progress: the client has restored the last state sent, and the
  /// message is not older than another one received.
  bool isCurrent(const PlayerInputs& message) const;
  /// The client wishes the next level, or no longer wishes it. The wish ends with the round and with the connection.
  /// Its first player has done something: nobody knows which of them has voted.
  void vote(bool next, std::uint64_t now);
  /// Whether this wish counts now (VoteWish), for each of its active players.
  bool wishesNext(std::uint64_t now) { return wish_.counts(now); }

  InputArrival& arrival() { return arrival_; }
  TickDelivery& ticks() { return ticks_; }
  const TickDelivery& ticks() const { return ticks_; }
  ClientTransfers& transfers() { return transfers_; }

 private:
  std::uint64_t addInputsOf(std::uint32_t local, const TickInputs& inputs, std::uint32_t decided, std::uint64_t now);

  std::optional<SessionToken> token_;
  IpAddress address_;
  std::map<std::uint32_t, MatchPlayer> players_;  // that of Hello always
  TickBudget companionBudget_{kCompanionsPerSecond, kCompanionBurst};
  std::array<std::uint64_t, kMaxLocalPlayers> answeredAt_ = {UINT64_MAX, UINT64_MAX, UINT64_MAX, UINT64_MAX};
  bool mayAddCompanions_ = true;
  bool mutesCompanions_ = false;
  VoteWish wish_;
  InputArrival arrival_;
  TickDelivery ticks_;
  ClientTransfers transfers_;
};

}  // namespace platon
