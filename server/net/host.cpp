#include "server/net/host.h"

#include <enet/enet.h>
#include <poll.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>
#include <random>

#include "protocol/enet_settings.h"
#include "protocol/limits.h"
#include "server/net/datagram_check.h"

namespace platon {
namespace {

// Keeps datagrams within 1200 bytes, whatever size the client requests. ENet does not count its checksum.
constexpr enet_uint32 kMtu = 1200 - sizeof(enet_uint32);
constexpr std::size_t kMaxWaitingBytes = 64 * 1024;
constexpr std::chrono::seconds kSilenceTimeout{5};    // an admitted connection without datagrams ends
constexpr std::chrono::seconds kSilenceSuspected{1};  // it no longer counts against its address
constexpr enet_uint32 kRetransmissionDelayMs = 150;   // beyond the round trip
constexpr enet_uint32 kThrottleIntervalMs = 5000;

// Budgets of a connection. A client sends at most one datagram of inputs a tick, and a few acknowledgements.
constexpr double kDatagramsPerSecond = 150;
constexpr double kDatagramBurst = 300;
constexpr double kBytesPerSecond = 32 * 1024;
constexpr double kByteBurst = 64 * 1024;
constexpr double kConnectsPerSecond = 2;
constexpr double kConnectBurst = 8;
constexpr std::size_t kConnectBuckets = 1024;  // a power of two

// Calls of enet_host_service in one tick: it stops receiving after an event and after an oversized datagram.
constexpr int kMaxServiceCalls = 64;

std::uint32_t octet(std::uint32_t networkOrder) {
  std::uint8_t bytes[sizeof networkOrder];
  std::memcpy(bytes, &networkOrder, sizeof networkOrder);
  return bytes[0];
}

bool isLoopback(const ENetAddress& address) { return octet(address.host) == 127; }

std::uint32_t originOf(const ENetAddress& address) { return isLoopback(address) ? 0 : address.host; }

// False for an address that the system cannot send to: ENet would then stop sending to all clients.
bool canSendTo(const ENetAddress& address) {
  return address.port != 0 && octet(address.host) != 0 && octet(address.host) < 224;
}

ENetAddress addressOf(const HostSettings& settings) {
  ENetAddress address{};
  address.port = settings.port;
  if (enet_address_set_host_ip(&address, settings.bind.c_str()) != 0) {
    throw HostError("cannot listen on '" + settings.bind + "': not an IPv4 address, such as 0.0.0.0 or 127.0.0.1");
  }
  return address;
}

std::string remedyFor(int fault) {
  if (fault == EADDRINUSE) return "; stop the program that uses it or choose another port";
  if (fault == EACCES) return "; choose a port above 1023";
  if (fault == EADDRNOTAVAIL) return "; choose an address of this machine, or 0.0.0.0 for all";
  return "";
}

ENetHost* open(const HostSettings& settings) {
  const ENetAddress address = addressOf(settings);
  errno = 0;
  ENetHost* host = enet_host_create(&address, settings.connections, kChannels, 0, 0);
  if (host) return host;
  const int fault = errno;
  throw HostError("cannot listen on " + settings.bind + ":" + std::to_string(settings.port) + ": " +
                  std::strerror(fault) + remedyFor(fault));
}

// Must be repeated, since the client can change these values at any time.
void resetLimits(ENetPeer& peer) {
  peer.mtu = kMtu;
  unthrottle(peer);
}

}  // namespace

struct Host::Connection {
  explicit Connection(TimePoint now)
      : since(now),
        receivedAt(now),
        datagrams(kDatagramsPerSecond, kDatagramBurst, now),
        bytes(kBytesPerSecond, kByteBurst, now) {}

  std::optional<ClientId> client;  // once connected
  bool open = false;               // connected or connecting
  bool admitted = false;
  bool closing = false;
  TimePoint since;       // when it became open, connected or closing, whichever came last
  TimePoint receivedAt;  // when the last datagram arrived
  TokenBucket datagrams;
  TokenBucket bytes;
};

// ENet passes the event that it fills to `intercept`, which gets host and time from it.
struct Host::Service : ENetEvent {
  Service(Host& owner, TimePoint time) : ENetEvent{}, host(owner), now(time) {}

  Host& host;
  TimePoint now;
};

Host::Host(const HostSettings& settings, TimePoint now)
    : host_(open(settings), enet_host_destroy),
      connectionsPerAddress_(settings.connectionsPerAddress),
      connections_(settings.connections, Connection(now)),
      connects_(kConnectBuckets, TokenBucket(kConnectsPerSecond, kConnectBurst, now)),
      connectKey_(std::random_device()() | 1) {
  enet_socket_get_address(host_->socket, &host_->address);  // the chosen port if 0 was requested
  host_->checksum = enet_crc32;
  host_->maximumPacketSize = kMaxMessageBytes;
  host_->maximumWaitingData = kMaxWaitingBytes;
  host_->mtu = kMtu;
  host_->randomSeed = std::random_device()();
  host_->intercept = &Host::intercept;
}

Host::~Host() = default;

int Host::intercept(ENetHost*, ENetEvent* event) {
  if (!event) return 1;
  const auto* service = static_cast<Service*>(event);
  return service->host.acceptsDatagram(service->now) ? 0 : 1;
}

bool Host::acceptsDatagram(TimePoint now) {
  const DatagramHead head = checkDatagram({host_->receivedData, host_->receivedDataLength});
  const bool invalid = head.kind == DatagramHead::Kind::kInvalid || !canSendTo(host_->receivedAddress) ||
                       (head.kind == DatagramHead::Kind::kPeer && head.peer >= connections_.size());
  if (invalid) {
    ++counters_.invalidDatagrams;
    return false;
  }
  if (head.kind == DatagramHead::Kind::kConnect) return acceptsConnect(now);
  const ENetAddress& known = host_->peers[head.peer].address;
  const ENetAddress& sender = host_->receivedAddress;
  if (known.host != sender.host || known.port != sender.port) return false;
  Connection& connection = connections_[head.peer];
  connection.receivedAt = now;
  const auto bytes = static_cast<double>(host_->receivedDataLength);
  const bool within = connection.datagrams.take(1, now) && connection.bytes.take(bytes, now);
  if (!within) ++counters_.excessDatagrams;
  return within;
}

bool Host::acceptsConnect(TimePoint now) {
  const bool loopback = isLoopback(host_->receivedAddress);
  host_->duplicatePeers = loopback ? host_->peerCount : connectionsPerAddress_ + silentConnectionsOfSender(now);
  const std::uint32_t bucket = (host_->receivedAddress.host * connectKey_) >> 22;
  static_assert(kConnectBuckets == std::size_t{1} << (32 - 22));
  const bool within = loopback || isRetransmittedConnect() || connects_[bucket].take(1, now);
  if (!within) ++counters_.excessConnects;
  return within;
}

// Connections of the sender that are probably lost. They do not count against the limit of its address, so that its
// clients can reconnect.
std::size_t Host::silentConnectionsOfSender(TimePoint now) const {
  std::size_t count = 0;
  for (std::size_t index = 0; index < connections_.size(); ++index) {
    const bool same = host_->peers[index].address.host == host_->receivedAddress.host;
    count += same && connections_[index].admitted && now - connections_[index].receivedAt > kSilenceSuspected ? 1 : 0;
  }
  return count;
}

// A request to connect is sent until it is answered. Only the first one counts against the budget.
bool Host::isRetransmittedConnect() const {
  const ENetAddress& sender = host_->receivedAddress;
  return std::any_of(host_->peers, host_->peers + host_->peerCount, [&sender](const ENetPeer& peer) {
    const bool taken = peer.state != ENET_PEER_STATE_DISCONNECTED;
    return taken && peer.address.host == sender.host && peer.address.port == sender.port;
  });
}

std::vector<HostEvent> Host::service(TimePoint now) {
  setEnetTime(now.time_since_epoch());
  std::vector<HostEvent> events;
  Service event(*this, now);
  for (int pass = 0; pass < kMaxServiceCalls; ++pass) {
    const int result = enet_host_service(host_.get(), &event, 0);
    if (result > 0) handle(event, now, events);
    while (enet_host_check_events(host_.get(), &event) > 0) handle(event, now, events);
    if (result == 0) break;
  }
  for (std::size_t index = 0; index < connections_.size(); ++index) maintain(index, now, events);
  return events;
}

void Host::handle(const ENetEvent& event, TimePoint now, std::vector<HostEvent>& events) {
  Connection& connection = connections_[event.peer->incomingPeerID];
  if (event.type == ENET_EVENT_TYPE_CONNECT) {
    if (!connection.open) connection = Connection(now);  // otherwise its first datagram came in an earlier call
    connection.open = true;
    connection.since = now;
    connection.client = nextClient_++;
    configurePeer(*event.peer);
    enet_peer_throttle_configure(event.peer, kThrottleIntervalMs, ENET_PEER_PACKET_THROTTLE_SCALE, 0);
    resetLimits(*event.peer);
  } else if (event.type == ENET_EVENT_TYPE_DISCONNECT) {
    if (connection.client) events.push_back({*connection.client, true, {}, 0});
    connection = Connection(now);
  } else if (event.type == ENET_EVENT_TYPE_RECEIVE) {
    const std::span<const std::uint8_t> bytes(event.packet->data, event.packet->dataLength);
    if (connection.client)
      events.push_back({*connection.client, false, {bytes.begin(), bytes.end()}, originOf(event.peer->address)});
    enet_packet_destroy(event.packet);
  }
}

// Maintains one connection: detects a new one, resets its limits, ends it if it has timed out.
void Host::maintain(std::size_t index, TimePoint now, std::vector<HostEvent>& events) {
  Connection& connection = connections_[index];
  ENetPeer& peer = host_->peers[index];
  if (peer.state == ENET_PEER_STATE_DISCONNECTED) {
    if (connection.open) connection = Connection(now);
    return;
  }
  if (!connection.open) {
    connection = Connection(now);
    connection.open = true;
  }
  resetLimits(peer);
  limitRetransmissionTimeout(peer, peer.roundTripTime + kRetransmissionDelayMs);
  const auto timeout = connection.client && !connection.closing ? kAdmissionTime : kAnswerTime;
  if (connection.admitted ? now - connection.receivedAt < kSilenceTimeout : now - connection.since < timeout) return;
  if (!connection.admitted) ++counters_.expired;
  if (connection.client) events.push_back({*connection.client, true, {}, 0});
  enet_peer_reset(&peer);
  connection = Connection(now);
}

ENetPeer* Host::peerOf(ClientId client) const {
  const auto found = std::find_if(connections_.begin(), connections_.end(),
                                  [client](const Connection& connection) { return connection.client == client; });
  return found == connections_.end() ? nullptr : &host_->peers[found - connections_.begin()];
}

void Host::admit(ClientId client) {
  if (const ENetPeer* peer = peerOf(client)) connections_[peer->incomingPeerID].admitted = true;
}

void Host::send(ClientId client, bool reliable, std::span<const std::uint8_t> message) {
  if (ENetPeer* peer = peerOf(client)) sendMessage(*peer, message, reliable);
}

void Host::close(ClientId client, TimePoint now) {
  ENetPeer* peer = peerOf(client);
  if (!peer) return;
  Connection& connection = connections_[peer->incomingPeerID];
  connection.admitted = false;
  connection.closing = true;
  connection.since = now;
  enet_peer_disconnect_later(peer, 0);
}

void Host::flush(TimePoint now) {
  setEnetTime(now.time_since_epoch());
  enet_host_flush(host_.get());
}

void Host::wait(std::chrono::milliseconds timeout) const {
  pollfd socket{host_->socket, POLLIN, 0};
  poll(&socket, 1, static_cast<int>(timeout.count()));
}

std::uint16_t Host::port() const { return host_->address.port; }

bool Host::isOpen(ClientId client) const {
  const ENetPeer* peer = peerOf(client);
  return peer && !connections_[peer->incomingPeerID].closing;
}

bool Host::empty() const {
  return std::none_of(connections_.begin(), connections_.end(),
                      [](const Connection& connection) { return connection.open; });
}

}  // namespace platon
