#pragma once

#include <cstdint>
#include <deque>

#include "tests/net/support/fake_client.h"
#include "tests/net/support/virtual_network.h"

namespace platon {

/// Duration of a tick, for LinkQuality.
inline constexpr double kTickMs = 1000.0 / kTicksPerSecond;

/// A match and its FakeClients in a virtual network. Time passes in whole ticks, so that tests can expect exact values:
/// in each tick the clients send, the match receives and ticks, and the clients receive. A message that is delayed by n
/// ticks arrives n ticks later.
class FakeClientNetwork : public VirtualNetwork {
 public:
  /// `quality`: of every connection.
  explicit FakeClientNetwork(Match match, const LinkQuality& quality = {.delayMs = kTickMs}, std::uint64_t seed = 1)
      : VirtualNetwork(std::move(match), seed), quality_(quality) {}

  /// Adds a client with the next number; the first is 1.
  FakeClient& add(FakeClient client);
  using VirtualNetwork::disconnect;
  /// The client leaves.
  void leave(ClientId client);
  void tick() { step(nextTick()); }
  void run(std::uint32_t ticks);

  FakeClient& client(ClientId client) { return clients_[client - 1]; }

 private:
  LinkQuality quality_;
  std::deque<FakeClient> clients_;
};

}  // namespace platon
