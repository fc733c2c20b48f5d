#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "tests/support/fake_client.h"

struct _ENetHost;
struct _ENetPeer;

namespace platon {

/// A FakeClient on a real ENet connection over loopback.
class EnetClient {
 public:
  /// Without a `client` it connects and sends only the bytes given to `sendRaw`.
  EnetClient(std::uint16_t port, std::optional<FakeClient> client);

  /// Receives what has arrived and sends the client's messages.
  void step();
  /// Sends bytes as a message.
  void sendRaw(const std::vector<std::uint8_t>& bytes, bool reliable);

  FakeClient& fake() { return *client_; }
  bool connected() const { return connected_; }
  /// Whether the server closed the connection.
  bool disconnected() const { return disconnected_; }
  std::uint16_t peerAtServer() const;
  std::uint32_t connectId() const;

 private:
  std::unique_ptr<_ENetHost, void (*)(_ENetHost*)> host_;
  _ENetPeer* peer_;
  std::optional<FakeClient> client_;
  bool connected_ = false;
  bool disconnected_ = false;
};

}  // namespace platon
