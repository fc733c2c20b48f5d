#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "client/net/client_line.h"
#include "client/session/network_client.h"

namespace platon {

/// A client on a simulated line, or on the real one when that is to be perfect.
class RelayedClient {
 public:
  /// Begins to connect, with the token of a lost player if one is given; the seed is of the line's draws. Throws
  /// std::runtime_error when that cannot even begin.
  RelayedClient(const ServerAddress& server, const std::string& name, const LinkQuality& line, std::uint64_t seed,
                Moment now, const std::optional<SessionToken>& token = std::nullopt);

  /// As of NetworkClient.
  void update(Moment now, const Controls& controls);

  NetworkClient* operator->() { return &client_; }
  const NetworkClient& operator*() const { return client_; }
  const NetworkClient* operator->() const { return &client_; }

 private:
  ClientLine line_;
  NetworkClient client_;
};

}  // namespace platon
