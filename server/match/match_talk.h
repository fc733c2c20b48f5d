#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>

#include "platon/game/game.h"
#include "protocol/chat.h"
#include "protocol/to_server.h"
#include "protocol/transport/socket_address.h"
#include "server/match/match_output.h"
#include "server/match/tick_budget.h"

namespace platon {

class MatchClient;
class MatchRoster;

/// How much may be said in a match, in ticks of the match.
class ChatBudget {
 public:
  /// Ticks after which a budget that was not used is full: 8 s.
  static constexpr auto kRefillTicks = static_cast<std::uint64_t>(kChatBurst / kChatsPerSecond * kTicksPerSecond);

  /// What so many players may say together.
  static ChatBudget ofPlayers(std::uint32_t players) { return ChatBudget(players); }

  /// Whether one more may be said at tick `now` of the match, which never decreases; it counts then.
  bool take(std::uint64_t now) { return budget_.take(now); }

 private:
  explicit ChatBudget(double players) : budget_(players * kChatsPerSecond, players * kChatBurst) {}

  TickBudget budget_;
};

/// What each network, a household or a site, may say in a match: as much as its players may together, also if they
/// leave and join again, which gives each of them a new budget. One network takes nothing from another.
class NetworkChat {
 public:
  /// Players whose budgets a network has at most: each text is sent to all players.
  static constexpr std::uint32_t kMaxSpeakers = 16;

  /// `players`: that a network may have.
  explicit NetworkChat(std::uint32_t players) : speakers_(std::min(players, kMaxSpeakers)) {}

  /// Whether the network may say one more at tick `now` of the match, which never decreases; it counts then.
  bool take(std::uint64_t network, std::uint64_t now) {
    std::erase_if(networks_, [now](const auto& each) { return now - each.second.usedAt >= ChatBudget::kRefillTicks; });
    Network& used = networks_.try_emplace(network, Network{ChatBudget::ofPlayers(speakers_), now}).first->second;
    used.usedAt = now;
    return used.budget.take(now);
  }
  /// Networks of which something is kept: those that have talked in the last ChatBudget::kRefillTicks.
  std::size_t size() const { return networks_.size(); }

 private:
  struct Network {
    ChatBudget budget;
    std::uint64_t usedAt;
  };

  std::uint32_t speakers_;
  std::map<std::uint64_t, Network> networks_;
};

/// What players say to each other. A text is passed on to all of them, the speaker too, if its player, its household
/// and its site may say something more, and if the operator has not muted the player.
class MatchTalk {
 public:
  /// `enabled`: otherwise nobody hears anything. `playersPerHousehold`: limit of the match.
  MatchTalk(bool enabled, std::uint32_t playersPerHousehold)
      : enabled_(enabled), households_(playersPerHousehold), sites_(NetworkChat::kMaxSpeakers) {}

  /// A player of a client, which has this number, says something at tick `now` of the match. No effect if the client
  /// has no player with the local number of the message.
  void say(ClientId id, MatchClient& client, const LocalChat& message, const MatchRoster& roster, std::uint64_t now,
           MatchOutput& output);

 private:
  bool mayChat(const IpAddress& address, std::uint64_t now);

  bool enabled_;
  NetworkChat households_;
  NetworkChat sites_;
};

}  // namespace platon
