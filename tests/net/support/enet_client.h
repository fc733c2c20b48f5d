#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "client/net/enet_link.h"
#include "tests/net/support/fake_client.h"

namespace platon {

/// A FakeClient on a real connection over loopback, in real time.
class EnetClient {
 public:
  /// Without a `client` it connects and sends only the bytes given to `sendRaw`.
  EnetClient(std::uint16_t port, std::optional<FakeClient> client);

  /// Receives what has arrived and sends the client's messages.
  void step();
  /// Sends bytes as a message.
  void sendRaw(const std::vector<std::uint8_t>& bytes, bool reliable);

  FakeClient& fake() { return *client_; }
  bool connected() const { return connection_.state() == EnetLink::State::kConnected; }
  /// Whether the server closed the connection.
  bool disconnected() const { return connection_.state() == EnetLink::State::kClosed; }

 private:
  EnetLink connection_;
  std::optional<FakeClient> client_;
};

}  // namespace platon
