#include "server/net/host.h"

#include <enet/enet.h>
#include <poll.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <random>

#include "protocol/enet_repeats.h"
#include "protocol/limits.h"
#include "server/net/datagram_check.h"

namespace platon {
namespace {

// Whole datagrams stay within 1200 bytes whatever the client asks for. ENet does not count its checksum when it fills
// one.
constexpr enet_uint32 kMtu = 1200 - sizeof(enet_uint32);
constexpr std::size_t kMaxWaitingBytes = 64 * 1024;
// ENet counts acknowledgements that are missing, of which a bad line has many: that nothing is heard says more.
constexpr enet_uint32 kTimeoutAttempts = 32;
constexpr enet_uint32 kTimeout = 30000;          // ms
constexpr std::chrono::seconds kSilence{5};      // of one that plays
constexpr std::chrono::seconds kDoubtful{1};     // likewise, after so long
constexpr enet_uint32 kPingInterval = 2000;      // ms; the messages of every tick show sooner that a line is dead
constexpr enet_uint32 kRepeatPause = 150;        // ms over a round trip until what is not acknowledged is repeated
constexpr enet_uint32 kThrottleInterval = 5000;  // ms

// A client sends at most one datagram of inputs a tick, and a few acknowledgements.
constexpr double kDatagramsPerSecond = 150;
constexpr double kDatagramBurst = 300;
constexpr double kBytesPerSecond = 32 * 1024;
constexpr double kByteBurst = 64 * 1024;
constexpr double kConnectsPerSecond = 2;
constexpr double kConnectBurst = 8;
constexpr std::size_t kConnectBuckets = 1024;  // a power of two

// ENet stops receiving at an event and at an oversized datagram; so often it is asked to go on in one tick.
constexpr int kPasses = 64;

std::uint32_t octet(std::uint32_t networkOrder) {
  std::uint8_t bytes[sizeof networkOrder];
  std::memcpy(bytes, &networkOrder, sizeof networkOrder);
  return bytes[0];
}

bool isLoopback(const ENetAddress& address) { return octet(address.host) == 127; }

std::uint32_t originOf(const ENetAddress& address) { return isLoopback(address) ? 0 : address.host; }

// ENet stops sending, to all, at an address that the system cannot send to.
bool canAnswer(const ENetAddress& address) {
  return address.port != 0 && octet(address.host) != 0 && octet(address.host) < 224;
}

// ENet's own clock is the wall clock, which may jump.
void setEnetTime(TimePoint now) {
  const auto time = std::chrono::duration_cast<std::chrono::milliseconds>(now.time_since_epoch()).count();
  enet_time_set(static_cast<enet_uint32>(time));
}

ENetAddress addressOf(const HostSettings& settings) {
  ENetAddress address{};
  address.port = settings.port;
  if (enet_address_set_host_ip(&address, settings.bind.c_str()) != 0) {
    throw HostError("cannot listen on '" + settings.bind + "': it is no IPv4 address, such as 0.0.0.0 or 127.0.0.1");
  }
  return address;
}

std::string mendOf(int fault) {
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
                  std::strerror(fault) + mendOf(fault));
}

// The client may say otherwise at any time, so this is done again and again.
void assertLimits(ENetPeer& peer) {
  peer.mtu = kMtu;
  peer.packetThrottle = peer.packetThrottleLimit = ENET_PEER_PACKET_THROTTLE_SCALE;
  peer.packetThrottleAcceleration = ENET_PEER_PACKET_THROTTLE_SCALE;
  peer.packetThrottleDeceleration = 0;
}

}  // namespace

struct Host::Link {
  explicit Link(TimePoint now)
      : since(now),
        heardAt(now),
        datagrams(kDatagramsPerSecond, kDatagramBurst, now),
        bytes(kBytesPerSecond, kByteBurst, now) {}

  std::optional<ClientId> client;  // once connected
  bool open = false;
  bool admitted = false;
  bool closing = false;
  TimePoint since;  // open, connected, or to be closed
  TimePoint heardAt;
  TokenBucket datagrams;
  TokenBucket bytes;
};

// ENet hands the event it fills to the interceptor, which finds its way back through it.
struct Host::Service : ENetEvent {
  Service(Host& owner, TimePoint time) : ENetEvent{}, host(owner), now(time) {}

  Host& host;
  TimePoint now;
};

Host::Host(const HostSettings& settings, TimePoint now)
    : host_(open(settings), enet_host_destroy),
      connectionsPerAddress_(settings.connectionsPerAddress),
      links_(settings.connections, Link(now)),
      connects_(kConnectBuckets, TokenBucket(kConnectsPerSecond, kConnectBurst, now)),
      connectKey_(std::random_device()() | 1) {
  enet_socket_get_address(host_->socket, &host_->address);  // the port, when any would do
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
  return service->host.lets(service->now) ? 0 : 1;
}

bool Host::lets(TimePoint now) {
  const DatagramHead head = checkDatagram({host_->receivedData, host_->receivedDataLength});
  const bool broken = head.kind == DatagramHead::Kind::kBroken || !canAnswer(host_->receivedAddress) ||
                      (head.kind == DatagramHead::Kind::kPeer && head.peer >= links_.size());
  if (broken) {
    ++counters_.brokenDatagrams;
    return false;
  }
  if (head.kind == DatagramHead::Kind::kConnect) return letsConnect(now);
  const ENetAddress& known = host_->peers[head.peer].address;
  const ENetAddress& sender = host_->receivedAddress;
  if (known.host != sender.host || known.port != sender.port) return false;
  Link& link = links_[head.peer];
  link.heardAt = now;
  const auto bytes = static_cast<double>(host_->receivedDataLength);
  const bool within = link.datagrams.take(1, now) && link.bytes.take(bytes, now);
  if (!within) ++counters_.excessDatagrams;
  return within;
}

bool Host::letsConnect(TimePoint now) {
  const bool loopback = isLoopback(host_->receivedAddress);
  host_->duplicatePeers = loopback ? host_->peerCount : connectionsPerAddress_ + silentOfSender(now);
  const std::uint32_t bucket = (host_->receivedAddress.host * connectKey_) >> 22;
  static_assert(kConnectBuckets == std::size_t{1} << (32 - 22));
  const bool within = loopback || isRepeated() || connects_[bucket].take(1, now);
  if (!within) ++counters_.excessConnects;
  return within;
}

// Connections that are probably dead do not keep their owners from coming back over others.
std::size_t Host::silentOfSender(TimePoint now) const {
  std::size_t count = 0;
  for (std::size_t index = 0; index < links_.size(); ++index) {
    const bool same = host_->peers[index].address.host == host_->receivedAddress.host;
    count += same && links_[index].admitted && now - links_[index].heardAt > kDoubtful ? 1 : 0;
  }
  return count;
}

// Repeated until it is answered, and takes no other place than the first time.
bool Host::isRepeated() const {
  const ENetAddress& sender = host_->receivedAddress;
  return std::any_of(host_->peers, host_->peers + host_->peerCount, [&sender](const ENetPeer& peer) {
    const bool taken = peer.state != ENET_PEER_STATE_DISCONNECTED;
    return taken && peer.address.host == sender.host && peer.address.port == sender.port;
  });
}

std::vector<HostEvent> Host::service(TimePoint now) {
  setEnetTime(now);
  std::vector<HostEvent> events;
  Service event(*this, now);
  for (int pass = 0; pass < kPasses; ++pass) {
    const int result = enet_host_service(host_.get(), &event, 0);
    if (result > 0) take(event, now, events);
    while (enet_host_check_events(host_.get(), &event) > 0) take(event, now, events);
    if (result == 0) break;
  }
  for (std::size_t index = 0; index < links_.size(); ++index) tend(index, now, events);
  return events;
}

void Host::take(const ENetEvent& event, TimePoint now, std::vector<HostEvent>& events) {
  Link& link = links_[event.peer->incomingPeerID];
  if (event.type == ENET_EVENT_TYPE_CONNECT) {
    if (!link.open) link = Link(now);  // else its first datagram came with an earlier call
    link.open = true;
    link.since = now;
    link.client = nextClient_++;
    enet_peer_timeout(event.peer, kTimeoutAttempts, kTimeout, kTimeout);
    enet_peer_ping_interval(event.peer, kPingInterval);
    enet_peer_throttle_configure(event.peer, kThrottleInterval, ENET_PEER_PACKET_THROTTLE_SCALE, 0);
    assertLimits(*event.peer);
  } else if (event.type == ENET_EVENT_TYPE_DISCONNECT) {
    if (link.client) events.push_back({*link.client, true, {}, 0});
    link = Link(now);
  } else if (event.type == ENET_EVENT_TYPE_RECEIVE) {
    const std::span<const std::uint8_t> bytes(event.packet->data, event.packet->dataLength);
    if (link.client)
      events.push_back({*link.client, false, {bytes.begin(), bytes.end()}, originOf(event.peer->address)});
    enet_packet_destroy(event.packet);
  }
}

void Host::tend(std::size_t index, TimePoint now, std::vector<HostEvent>& events) {
  Link& link = links_[index];
  ENetPeer& peer = host_->peers[index];
  if (peer.state == ENET_PEER_STATE_DISCONNECTED) {
    if (link.open) link = Link(now);
    return;
  }
  if (!link.open) {
    link = Link(now);
    link.open = true;
  }
  assertLimits(peer);
  limitPauses(peer, peer.roundTripTime + kRepeatPause);
  const bool greets = link.client && !link.closing;
  if (link.admitted ? now - link.heardAt < kSilence : now - link.since < (greets ? kAdmissionTime : kAnswerTime))
    return;
  if (!link.admitted) ++counters_.expired;
  if (link.client) events.push_back({*link.client, true, {}, 0});
  enet_peer_reset(&peer);
  link = Link(now);
}

ENetPeer* Host::peerOf(ClientId client) const {
  const auto found = std::find_if(links_.begin(), links_.end(), [client](const Link& l) { return l.client == client; });
  return found == links_.end() ? nullptr : &host_->peers[found - links_.begin()];
}

void Host::admit(ClientId client) {
  if (const ENetPeer* peer = peerOf(client)) links_[peer->incomingPeerID].admitted = true;
}

void Host::send(ClientId client, bool reliable, std::span<const std::uint8_t> message) {
  ENetPeer* peer = peerOf(client);
  if (!peer) return;
  const enet_uint32 flags = reliable ? ENET_PACKET_FLAG_RELIABLE : ENET_PACKET_FLAG_UNSEQUENCED;
  ENetPacket* packet = enet_packet_create(message.data(), message.size(), flags);
  const bool queued = packet && enet_peer_send(peer, reliable ? kReliableChannel : kTickChannel, packet) == 0;
  if (packet && !queued) enet_packet_destroy(packet);
}

void Host::close(ClientId client, TimePoint now) {
  ENetPeer* peer = peerOf(client);
  if (!peer) return;
  Link& link = links_[peer->incomingPeerID];
  link.admitted = false;
  link.closing = true;
  link.since = now;
  enet_peer_disconnect_later(peer, 0);
}

void Host::flush(TimePoint now) {
  setEnetTime(now);
  enet_host_flush(host_.get());
}

void Host::wait(std::chrono::milliseconds atMost) const {
  pollfd socket{host_->socket, POLLIN, 0};
  poll(&socket, 1, static_cast<int>(atMost.count()));
}

std::uint16_t Host::port() const { return host_->address.port; }

bool Host::listensTo(ClientId client) const {
  const ENetPeer* peer = peerOf(client);
  return peer && !links_[peer->incomingPeerID].closing;
}

bool Host::empty() const {
  return std::none_of(links_.begin(), links_.end(), [](const Link& link) { return link.open; });
}

}  // namespace platon
