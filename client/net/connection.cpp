#include "client/net/connection.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include "protocol/enet_settings.h"
#include "protocol/limits.h"

namespace platon {

namespace {

// Round trip assumed until one is measured. A lost connection request is sent again after this time.
constexpr enet_uint32 kInitialRoundTripMs = 100;

ENetAddress resolve(const ServerAddress& server) {
  ENetAddress address{};
  if (enet_address_set_host(&address, server.host.c_str()) != 0) {
    throw std::runtime_error("cannot resolve host " + server.host);
  }
  address.port = server.port;
  return address;
}

// Longest datagram that this thread has sent or received since countTraffic() last reset it. Measured in the checksum
// function, the only place where ENet reveals the length of each datagram.
thread_local std::uint64_t longestDatagram = 0;

enet_uint32 measuringChecksum(const ENetBuffer* buffers, std::size_t count) {
  std::uint64_t bytes = 0;
  for (std::size_t i = 0; i < count; ++i) bytes += buffers[i].dataLength;
  longestDatagram = std::max(longestDatagram, bytes);
  return enet_crc32(buffers, count);
}

}  // namespace

Connection::Connection(const ServerAddress& server, Moment now) {
  const ENetAddress address = resolve(server);
  setEnetTime(now);
  host_.reset(enet_host_create(nullptr, 1, kChannels, 0, 0));
  if (!host_) throw std::runtime_error("cannot open a UDP socket");
  host_->checksum = measuringChecksum;
  host_->maximumPacketSize = kMaxMessageBytes;
  peer_ = enet_host_connect(host_.get(), &address, kChannels, 0);
  if (peer_ == nullptr) throw std::runtime_error("cannot connect to " + server.text());
  peer_->roundTripTime = kInitialRoundTripMs;
  configurePeer(*peer_);
}

Connection::~Connection() {
  if (state_ != State::kClosed) enet_peer_reset(peer_);
}

// Stops ENet from dropping unreliable packets when the round trip grows; the server could turn that on.
void Connection::disableThrottle() {
  if (state_ != State::kConnected) return;  // while connecting, the server must echo the original values
  unthrottle(*peer_);
}

void Connection::limitRequestInterval() {
  if (state_ == State::kConnecting) limitRetransmissionTimeout(*peer_, kRequestInterval / std::chrono::milliseconds(1));
}

ServerAddress Connection::address() const {
  std::array<char, 16> text{};
  enet_address_get_host_ip(&peer_->address, text.data(), text.size());
  return {text.data(), peer_->address.port};
}

void Connection::service(Moment now, const Receiver& receiver) {
  setEnetTime(now);
  disableThrottle();
  limitRequestInterval();
  ENetEvent event{};
  for (std::uint32_t events = 0; events < kMaxMessagesPerService; ++events) {
    if (enet_host_service(host_.get(), &event, 0) <= 0) break;
    handle(event, receiver);
  }
  countTraffic();
}

void Connection::handle(const ENetEvent& event, const Receiver& receiver) {
  if (event.type == ENET_EVENT_TYPE_CONNECT) {
    state_ = State::kConnected;
  } else if (event.type == ENET_EVENT_TYPE_DISCONNECT) {
    state_ = State::kClosed;
  } else if (event.type == ENET_EVENT_TYPE_RECEIVE) {
    receiver({event.packet->data, event.packet->dataLength});
    enet_packet_destroy(event.packet);
  }
}

void Connection::flush(Moment now) {
  setEnetTime(now);
  enet_host_flush(host_.get());
  countTraffic();
}

void Connection::countTraffic() {
  traffic_.longestDatagram = std::max(traffic_.longestDatagram, std::exchange(longestDatagram, 0));
  traffic_.sentBytes += std::exchange(host_->totalSentData, 0);
  traffic_.sentPackets += std::exchange(host_->totalSentPackets, 0);
  traffic_.receivedBytes += std::exchange(host_->totalReceivedData, 0);
  traffic_.receivedPackets += std::exchange(host_->totalReceivedPackets, 0);
}

void Connection::send(std::span<const std::uint8_t> message, bool reliable) {
  if (state_ == State::kConnected) sendMessage(*peer_, message, reliable);
}

void Connection::close() {
  if (state_ == State::kConnected) enet_peer_disconnect_later(peer_, 0);
}

}  // namespace platon
