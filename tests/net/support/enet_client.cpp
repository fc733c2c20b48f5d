#include "tests/net/support/enet_client.h"

#include "client/time/steady_now.h"
#include "protocol/transport/udp_socket.h"

namespace platon {

EnetClient::EnetClient(std::uint16_t port, std::optional<FakeClient> client)
    : connection_(resolve("127.0.0.1", port), {}), client_(std::move(client)) {}

void EnetClient::step() {
  connection_.service(steadyClock().now(), [this](std::span<const std::uint8_t> message) {
    if (client_) client_->receive({message.begin(), message.end()}, Time());
  });
  if (!client_ || !connected()) return;
  client_->update(Time());
  for (const OutgoingMessage& message : client_->takeOutgoing()) sendRaw(message.bytes, message.reliable);
}

void EnetClient::sendRaw(const std::vector<std::uint8_t>& bytes, bool reliable) {
  connection_.send(bytes, reliable);
  connection_.flush(steadyClock().now());
}

}  // namespace platon
