#pragma once

#include <cstdint>
#include <optional>

#include "client/net/lossy_relay.h"

namespace platon {

/// The line from a client to its server: a relay of its own, or the real one when that is to be perfect.
class ClientLine {
 public:
  /// The seed is of the draws. Throws std::runtime_error as LossyRelay does.
  ClientLine(const ServerAddress& server, const LinkQuality& quality, std::uint64_t seed) : server_(server) {
    if (!quality.perfect()) relay_.emplace(server, quality, seed);
  }

  /// Where the client finds the server.
  ServerAddress address() const { return relay_ ? relay_->address() : server_; }
  /// To be called before the client looks for what has come, and after it has sent.
  void pump(Moment now) {
    if (relay_) relay_->pump(now);
  }

 private:
  ServerAddress server_;
  std::optional<LossyRelay> relay_;
};

}  // namespace platon
