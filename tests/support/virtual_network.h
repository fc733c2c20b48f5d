#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <random>
#include <vector>

#include "server/match/match.h"
#include "tests/support/fake_client.h"

namespace platon {

/// A match and its clients in virtual time. Messages arrive some ticks later; unsequenced ones can be lost or
/// reordered.
class VirtualNetwork {
 public:
  struct Conditions {
    std::uint32_t delay = 1;   ///< ticks, each way
    std::uint32_t jitter = 0;  ///< largest additional delay, ticks
    double loss = 0;           ///< share of unsequenced messages that is lost, 0 … 1
    std::uint64_t seed = 1;
  };

  VirtualNetwork(Match match, Conditions conditions)
      : match_(std::move(match)), conditions_(conditions), random_(conditions.seed) {}

  /// Adds a client with the next number; the first is 1.
  FakeClient& add(FakeClient client);
  /// The client's connection is lost.
  void disconnect(ClientId client);
  /// The client leaves.
  void leave(ClientId client);
  /// Runs one tick of the match, the clients and the network.
  void tick();
  void run(std::uint32_t ticks);

  Match& match() { return match_; }
  FakeClient& client(ClientId client) { return *links_[client - 1].client; }
  /// All events of the match so far.
  const std::vector<MatchEvent>& events() const { return events_; }
  std::size_t count(MatchEvent::Kind kind) const;
  /// The longest unsequenced message to a client so far.
  std::size_t longest() const { return longest_; }
  /// Hash of the server's game by round and tick.
  std::uint64_t hashOf(std::uint32_t round, std::uint32_t tick) const { return hashes_.at({round, tick}); }

 private:
  using Bytes = std::vector<std::uint8_t>;
  struct Parcel {
    std::uint64_t due = 0;
    Bytes bytes;
  };
  struct Link {
    std::unique_ptr<FakeClient> client;
    bool connected = true;
    std::deque<Parcel> up, down;  // reliable, in order
    std::vector<Parcel> upUnsequenced, downUnsequenced;
  };

  std::uint64_t arrival();
  void post(std::deque<Parcel>& queue, Bytes bytes);
  void post(std::vector<Parcel>& queue, Bytes bytes);
  template <class Take>
  void receive(std::deque<Parcel>& queue, std::vector<Parcel>& unsequenced, Take take);
  void deliverToMatch();
  void deliverToClients();

  Match match_;
  Conditions conditions_;
  std::mt19937_64 random_;
  std::vector<Link> links_;
  std::vector<MatchEvent> events_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint64_t> hashes_;
  std::uint64_t now_ = 0;
  std::size_t longest_ = 0;
};

}  // namespace platon
