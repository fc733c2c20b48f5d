#include "tests/support/enet_client.h"

#include <enet/enet.h>

#include "protocol/limits.h"

namespace platon {
namespace {

_ENetPeer* connectTo(_ENetHost& host, std::uint16_t port) {
  host.checksum = enet_crc32;
  ENetAddress server{};
  enet_address_set_host_ip(&server, "127.0.0.1");
  server.port = port;
  return enet_host_connect(&host, &server, kChannels, 0);
}

}  // namespace

EnetClient::EnetClient(std::uint16_t port, std::optional<FakeClient> client)
    : host_(enet_host_create(nullptr, 1, kChannels, 0, 0), enet_host_destroy),
      peer_(connectTo(*host_, port)),
      client_(std::move(client)) {}

void EnetClient::step() {
  ENetEvent event;
  while (enet_host_service(host_.get(), &event, 0) > 0) {
    if (event.type == ENET_EVENT_TYPE_CONNECT) connected_ = true;
    if (event.type == ENET_EVENT_TYPE_DISCONNECT) disconnected_ = true;
    if (event.type != ENET_EVENT_TYPE_RECEIVE) continue;
    if (client_) client_->receive({event.packet->data, event.packet->data + event.packet->dataLength}, Moment());
    enet_packet_destroy(event.packet);
  }
  if (!client_ || !connected_ || disconnected_) return;
  client_->update(Moment());
  for (const OutgoingMessage& message : client_->takeOutgoing()) sendRaw(message.bytes, message.reliable);
}

void EnetClient::sendRaw(const std::vector<std::uint8_t>& bytes, bool reliable) {
  const enet_uint32 flags = reliable ? ENET_PACKET_FLAG_RELIABLE : ENET_PACKET_FLAG_UNSEQUENCED;
  ENetPacket* packet = enet_packet_create(bytes.data(), bytes.size(), flags);
  if (enet_peer_send(peer_, reliable ? kReliableChannel : kTickChannel, packet) != 0) enet_packet_destroy(packet);
  enet_host_flush(host_.get());
}

std::uint16_t EnetClient::peerAtServer() const { return peer_->outgoingPeerID; }

std::uint32_t EnetClient::connectId() const { return peer_->connectID; }

}  // namespace platon
