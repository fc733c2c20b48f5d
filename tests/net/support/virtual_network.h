#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "client/net/network_conditions.h"
#include "protocol/time.h"
#include "server/match/match.h"
#include "tests/net/support/virtual_client.h"

namespace platon {

/// A match and its clients in one thread and in virtual time, connected by simulated connections. Unreliable messages
/// are subject to all conditions of a connection, reliable ones only to its delay and jitter, as if the transport below
/// retransmitted them.
class VirtualNetwork {
 public:
  Time now() const { return now_; }
  Match& match() { return match_; }
  /// All events of the match up to its last tick.
  const std::vector<MatchEvent>& events() const { return events_; }
  std::size_t count(MatchEvent::Kind kind) const;
  /// Hash of the server's game. Nothing for a tick that it has not played, and for the last tick of a round.
  std::optional<std::uint64_t> hashOf(std::uint32_t round, std::uint32_t tick) const;
  /// Whether the match has replaced the game of this round by that of the next one right after this tick.
  bool isLast(std::uint32_t round, std::uint32_t tick) const;
  /// Size of the longest unreliable message to a client so far.
  std::size_t longest() const { return longest_; }

 protected:
  VirtualNetwork(Match match, std::uint64_t seed) : match_(std::move(match)), seed_(seed) {}
  ~VirtualNetwork() = default;

  /// Connects a client, with the same quality in both directions. Returns the number of the connection; the first is 1.
  ClientId connect(VirtualClient& client, const LinkQuality& quality);
  /// The connection is lost, with all messages in flight. The server detects it after `detectedAfter`; nothing: never.
  void disconnect(ClientId client, std::optional<Time> detectedAfter = Time::zero());
  /// When the match ticks next.
  Time nextTick() const;
  /// Lets time pass until `now`: updates the clients, delivers what they send, lets the match tick if it is due, and
  /// delivers what the match sends.
  void step(Time now);

 private:
  using Bytes = std::vector<std::uint8_t>;

  /// One direction of a connection.
  class Direction {
   public:
    Direction(const LinkQuality& quality, std::uint64_t seed);

    void send(Bytes bytes, bool reliable, Time now);
    /// The next message that has arrived.
    std::optional<Bytes> receive(Time now);

   private:
    NetworkConditions unreliable_, reliable_;
  };

  struct Connection {
    VirtualClient* client;
    Direction up, down;
  };

  void detectDisconnects();
  void deliverToMatch(ClientId client, Connection& connection);
  void tick();

  static constexpr Time kStart = std::chrono::seconds(100);

  Match match_;
  std::uint64_t seed_;
  Time now_ = kStart;
  std::int64_t ticks_ = 0;  // of the server, without players too
  ClientId lastClient_ = 0;
  std::map<ClientId, Connection> connections_;
  std::vector<std::pair<Time, ClientId>> losses_;  // when the server detects which lost connection
  std::vector<MatchEvent> events_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint64_t> hashes_;  // of the server's game, by round and tick
  std::size_t longest_ = 0;
};

}  // namespace platon
