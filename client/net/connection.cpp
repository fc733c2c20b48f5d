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

// Taken for the round trip until one is measured: a lost greeting is repeated after this time.
constexpr enet_uint32 kFirstRoundTripMs = 100;
constexpr enet_uint32 kPingIntervalMs = 2000;  // the messages of every tick show sooner that a line is dead
constexpr enet_uint32 kTimeoutLimit = 32;
// ENet counts acknowledgements that are missing, of which a bad line has many; Session knows sooner by its silence.
constexpr enet_uint32 kTimeoutMs = 30000;

ENetAddress resolve(const ServerAddress& server) {
  ENetAddress address{};
  if (enet_address_set_host(&address, server.host.c_str()) != 0) {
    throw std::runtime_error("the host " + server.host + " is not known");
  }
  address.port = server.port;
  return address;
}

// ENet goes by the wall clock unless told otherwise.
void tellTime(Moment now) {
  enet_time_set(static_cast<enet_uint32>(std::chrono::duration_cast<std::chrono::milliseconds>(now).count()));
}

// Of this thread, since it was last asked for. ENet gives every whole datagram, sent or received, to the checksum, and
// tells the length of each nowhere else.
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
  tellTime(now);
  host_.reset(enet_host_create(nullptr, 1, kChannels, 0, 0));
  if (!host_) throw std::runtime_error("no socket left for a connection");
  host_->checksum = measuringChecksum;
  host_->maximumPacketSize = kMaxMessageBytes;
  peer_ = enet_host_connect(host_.get(), &address, kChannels, 0);
  if (peer_ == nullptr) throw std::runtime_error("no connection can be made to " + server.text());
  peer_->roundTripTime = kFirstRoundTripMs;
  enet_peer_ping_interval(peer_, kPingIntervalMs);
  enet_peer_timeout(peer_, kTimeoutLimit, kTimeoutMs, kTimeoutMs);
}

Connection::~Connection() {
  if (state_ != State::kClosed) enet_peer_reset(peer_);
}

void Connection::keepUnthrottled() {
  if (state_ != State::kConnected) return;  // until then the server must echo what it was first told
  // ENet would drop unreliable packets whenever the round trip grows, and lets the other side ask for it.
  peer_->packetThrottle = ENET_PEER_PACKET_THROTTLE_SCALE;
  peer_->packetThrottleLimit = ENET_PEER_PACKET_THROTTLE_SCALE;
  peer_->packetThrottleDeceleration = 0;
}

void Connection::keepCalling() {
  if (state_ == State::kConnecting) limitRetransmissionTimeout(*peer_, kBetweenCalls / std::chrono::milliseconds(1));
}

ServerAddress Connection::address() const {
  std::array<char, 16> text{};
  enet_address_get_host_ip(&peer_->address, text.data(), text.size());
  return {text.data(), peer_->address.port};
}

void Connection::service(Moment now, const Receiver& receiver) {
  tellTime(now);
  keepUnthrottled();
  keepCalling();
  ENetEvent event{};
  while (enet_host_service(host_.get(), &event, 0) > 0) handle(event, receiver);
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
  tellTime(now);
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
  if (state_ != State::kConnected) return;
  const enet_uint32 flags = reliable ? ENET_PACKET_FLAG_RELIABLE : ENET_PACKET_FLAG_UNSEQUENCED;
  ENetPacket* const packet = enet_packet_create(message.data(), message.size(), flags);
  const std::uint8_t channel = reliable ? kReliableChannel : kTickChannel;
  if (packet != nullptr && enet_peer_send(peer_, channel, packet) != 0) enet_packet_destroy(packet);
}

void Connection::close() {
  if (state_ == State::kConnected) enet_peer_disconnect_later(peer_, 0);
}

}  // namespace platon
