#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <random>
#include <vector>

#include "server/match/match.h"
#include "tests/support/fake_client.h"

namespace platon {

/// A match and its clients in virtual time: what is sent arrives some ticks later; of the unsequenced messages some are
/// lost and all may overtake each other.
class VirtualNetwork {
 public:
  struct Conditions {
    std::uint32_t delay = 1;   ///< ticks, each way
    std::uint32_t jitter = 0;  ///< up to so many ticks more
    double loss = 0;           ///< share of unsequenced messages
    std::uint64_t seed = 1;
  };

  VirtualNetwork(Match match, Conditions conditions)
      : match_(std::move(match)), conditions_(conditions), random_(conditions.seed) {}

  /// Adds a client under the next number, from 1 on.
  FakeClient& add(FakeClient client);
  /// The client's connection breaks.
  void breakOff(ClientId client);
  /// The client goes.
  void leave(ClientId client);
  /// One tick of everything.
  void tick();
  void run(std::uint32_t ticks);

  Match& match() { return match_; }
  FakeClient& client(ClientId client) { return *links_[client - 1].client; }
  /// Everything that has happened in the match.
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
    std::deque<Parcel> up, down;             // reliable, in order
    std::vector<Parcel> upLoose, downLoose;  // unsequenced
  };

  std::uint64_t arrival();
  void post(std::deque<Parcel>& queue, Bytes bytes);
  void post(std::vector<Parcel>& queue, Bytes bytes);
  template <class Take>
  void receive(std::deque<Parcel>& queue, std::vector<Parcel>& loose, Take take);
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
