#pragma once

#include <cstdint>
#include <optional>

#include "client/net/lossy_relay.h"

namespace platon {

/// A bot's route to the server: direct, or through a relay of its own that simulates network conditions.
class ServerRoute {
 public:
  /// Uses a relay unless `quality` is perfect. `seed`: of the relay's random numbers. Throws std::runtime_error as
  /// LossyRelay does.
  ServerRoute(const ServerAddress& server, const LinkQuality& quality, std::uint64_t seed) : server_(server) {
    if (!quality.perfect()) relay_.emplace(server, quality, seed);
  }

  /// The address to connect to.
  ServerAddress address() const { return relay_ ? relay_->address() : server_; }
  /// Forwards datagrams. Call before the bot receives and after it has sent.
  void pump(Moment now) {
    if (relay_) relay_->pump(now);
  }

 private:
  ServerAddress server_;
  std::optional<LossyRelay> relay_;
};

}  // namespace platon
