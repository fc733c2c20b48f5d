#include "server/net/host.h"

#include <enet/enet.h>
#include <sodium.h>

#include <algorithm>
#include <utility>

#include "protocol/transport/enet_layer.h"
#include "protocol/transport/udp_socket.h"

namespace platon {
namespace {

constexpr std::size_t kMaxWaitingBytes = 8 * 1024;   // kept after a gap; a client says little that is reliable
constexpr std::chrono::seconds kSilenceTimeout{5};   // an admitted connection without datagrams ends
constexpr enet_uint32 kRetransmissionDelayMs = 150;  // beyond the round trip

// Budgets of a connection. A client sends at most one datagram of inputs a tick, and a few acknowledgements.
constexpr double kDatagramsPerSecond = 150;
constexpr double kDatagramBurst = 300;
constexpr double kBytesPerSecond = 32 * 1024;
constexpr double kByteBurst = 64 * 1024;

// What a connection is sent again, and how much may be on the way, grow with what it acknowledges; otherwise somebody
// who acknowledges nothing would be sent a multiple of what he sends. After an interruption of the network, the
// smallest rate lets the first acknowledgements come.
constexpr double kResentBytesPerSecond = 384;
constexpr double kResentBytesLimit = 64 * 1024;
constexpr double kFirstResentBytes = 1536;
constexpr std::size_t kFirstWindow = 4 * 1024;
constexpr std::size_t kMaxWindow = ENET_PROTOCOL_MAXIMUM_WINDOW_SIZE;
constexpr std::size_t kGainOfAcknowledged = 2;  // bytes for each byte acknowledged

// Calls of enet_host_service in one call of service: it stops receiving after an event.
constexpr int kMaxServiceCalls = 64;

ENetAddress toEnet(SessionId session) { return {session.number, session.slot}; }
SessionId fromEnet(const ENetAddress& address) { return {address.host, address.port}; }

GateSettings gateSettings(const HostSettings& settings) {
  return {settings.connections, settings.connectionsPerAddress, settings.presharedKey, settings.needsPassword};
}

// Reliable messages that were not acknowledged yet.
std::size_t queuedMessages(ENetPeer& peer) {
  std::size_t count = 0;
  for (ENetList* list : {&peer.sentReliableCommands, &peer.outgoingCommands}) {
    for (ENetListIterator each = enet_list_begin(list); each != enet_list_end(list); each = enet_list_next(each)) {
      const auto* command = reinterpret_cast<const ENetOutgoingCommand*>(each);
      count += command->packet != nullptr && (command->packet->flags & ENET_PACKET_FLAG_RELIABLE) != 0 ? 1 : 0;
    }
  }
  return count;
}

std::size_t roomOf(ENetPeer& peer) {
  return Host::kMaxQueuedMessages - std::min(Host::kMaxQueuedMessages, queuedMessages(peer));
}

}  // namespace

Host::Connection::Connection(Time now, SessionId own)
    : session(own),
      since(now),
      receivedAt(now),
      datagrams(kDatagramsPerSecond, kDatagramBurst, now),
      bytes(kBytesPerSecond, kByteBurst, now),
      resends(kResentBytesPerSecond, kResentBytesLimit, now),
      window(kFirstWindow) {
  resends.take(kResentBytesLimit - kFirstResentBytes, now);
}

bool Host::Connection::charge(std::size_t size, Rejections& rejections, Time now) {
  const bool within = datagrams.take(1, now) && bytes.take(static_cast<double>(size), now);
  if (!within) ++rejections.excess;
  return within;
}

// Decides what ENet takes for lost and sends again. What the connection may not be sent now is due again with the next
// call.
void Host::Connection::limitResends(ENetPeer& peer, Time now) {
  limitRetransmissionTimeout(peer, peer.roundTripTime + kRetransmissionDelayMs);
  postponeRetransmissions(peer, enet_time_get(), [&](const ENetOutgoingCommand& command) {
    return resends.take(static_cast<double>(bytesOf(command) + SealedChannel::kOverhead), now);
  });
}

// What was outstanding and is no longer has been acknowledged. Only ENet knows: it ignores an acknowledgement with a
// time in the future, and all that follow a command which it refuses. Call it before ENet receives anything, too,
// because what was sent since may be acknowledged at once.
void Host::Connection::noteOutstanding(const ENetPeer& peer, Time now) {
  const std::vector<Outstanding> before = std::exchange(outstanding, {});
  forEachOutstanding(peer, [&](const ENetOutgoingCommand& command) {
    outstanding.push_back({command.command.header.channelID, command.reliableSequenceNumber, bytesOf(command), now});
  });
  std::size_t acknowledged = 0;
  for (const Outstanding& each : before) {
    const auto same = std::find_if(outstanding.begin(), outstanding.end(), [&](const Outstanding& still) {
      return still.channel == each.channel && still.sequence == each.sequence;
    });
    if (same == outstanding.end()) {
      acknowledged += each.bytes;
    } else {
      same->since = each.since;
    }
  }
  resends.add(static_cast<double>(kGainOfAcknowledged * acknowledged));
  window = std::min(window + kGainOfAcknowledged * acknowledged, kMaxWindow);
}

bool Host::Connection::hasTimedOut(Rejections& rejections, Time now) const {
  const bool isSlow = std::any_of(outstanding.begin(), outstanding.end(),
                                  [&](const Outstanding& each) { return now - each.since >= kMaxUnacknowledged; });
  if (isSlow) {
    ++rejections.slow;
    return true;
  }
  if (admitted) {
    const bool isSilent = now - receivedAt >= kSilenceTimeout;
    rejections.silent += isSilent ? 1 : 0;
    return isSilent;
  }
  const bool isIdle = now - since >= (client && !closing ? kAdmissionTime : kAnswerTime);
  rejections.idle += isIdle && !closing ? 1 : 0;
  return isIdle;
}

Host::Host(std::unique_ptr<DatagramSocket> socket, const ServerIdentity& identity, const HostSettings& settings,
           Time now, HostRules rules)
    : gate_(std::move(socket), identity, gateSettings(settings), now, gateRules(std::move(rules))),
      host_(createEnetHost(settings.connections, randombytes_random()), enet_host_destroy),
      connections_(settings.connections, Connection(now)),
      now_(now) {
  if (!host_ || !enetUsesOurCalls())
    throw SocketError("cannot use ENet: this program was linked without its transport");
  host_->maximumWaitingData = kMaxWaitingBytes;
}

Host::~Host() = default;

// A session that is no client yet may move.
GateRules Host::gateRules(HostRules rules) {
  GateRules gate{std::move(rules.ban), std::move(rules.banned), {}};
  if (!rules.mayMove) return gate;
  gate.mayMove = [this, mayMove = std::move(rules.mayMove)](SessionId session, const IpAddress& address) {
    const auto found = std::find_if(connections_.begin(), connections_.end(), [session](const Connection& connection) {
      return connection.client && connection.session == session;
    });
    return found == connections_.end() || mayMove(*found->client, address);
  };
  return gate;
}

void Host::sendFromEnet(const ENetAddress& session, ByteSpan bytes) { gate_.send(fromEnet(session), bytes, now_); }

std::optional<EnetPort::Received> Host::receiveForEnet() {
  while (std::optional<ServerGate::Received> received = gate_.receive(now_)) {
    if (!accepts(received->session, received->bytes)) continue;
    content_ = std::move(received->bytes);
    return Received{toEnet(received->session), content_};
  }
  return std::nullopt;
}

// Whether ENet may see the content, without what was removed from it.
bool Host::accepts(SessionId session, Bytes& content) {
  std::optional<EnetCommands> commands = readEnetCommands(content, EnetSender::kClient);
  if (commands && commands->isConnect()) return acceptsConnect(session, commands->connectId, content.size());
  const bool isPeer = commands && commands->peer < connections_.size() &&
                      fromEnet(host_->peers[commands->peer].address) == session &&
                      areSequencesNear(*commands, host_->peers[commands->peer]);
  if (!isPeer) {
    ++rejections().content;
    return false;
  }
  Connection& connection = connections_[commands->peer];
  connection.receivedAt = now_;
  if (!connection.charge(content.size(), rejections(), now_)) return false;
  removeFalseAcknowledgements(content, *commands, host_->peers[commands->peer]);
  return commands->count != 0;
}

// A session has one connection, so that requests cost no more than the handshakes before them. A client repeats its
// request until the answer arrives; ENet repeats the answer.
bool Host::acceptsConnect(SessionId session, std::uint32_t connectId, std::size_t bytes) {
  const auto found = std::find_if(connections_.begin(), connections_.end(),
                                  [&](const Connection& each) { return each.session == session; });
  if (found == connections_.end()) return begin(session, bytes);
  const ENetPeer& peer = host_->peers[found - connections_.begin()];
  if (peer.state != ENET_PEER_STATE_DISCONNECTED && peer.connectID == connectId) {
    found->charge(bytes, rejections(), now_);
  } else {
    ++rejections().content;
  }
  return false;
}

// ENet gives the session its first free peer. The connection before may have ended a moment ago, without an event.
bool Host::begin(SessionId session, std::size_t bytes) {
  std::size_t index = 0;
  while (index < connections_.size() && host_->peers[index].state != ENET_PEER_STATE_DISCONNECTED) ++index;
  if (index == connections_.size()) return false;
  if (connections_[index].session.number != 0) end(index);
  connections_[index] = Connection(now_, session);
  return connections_[index].charge(bytes, rejections(), now_);
}

std::span<const HostEvent> Host::service(Time now) {
  now_ = now;
  gate_.beginRound();
  const EnetScope scope(*this, now);
  events_.clear();
  packets_.clear();
  endSlow();
  for (std::size_t index = 0; index < connections_.size(); ++index) {
    connections_[index].limitResends(host_->peers[index], now);
    connections_[index].noteOutstanding(host_->peers[index], now);
  }
  ENetEvent event{};
  for (int pass = 0; pass < kMaxServiceCalls; ++pass) {
    const int result = serviceEnet(*host_, event);
    if (result > 0) handle(event);
    while (enet_host_check_events(host_.get(), &event) > 0) handle(event);
    if (result <= 0) break;
  }
  for (std::size_t index = 0; index < connections_.size(); ++index) maintain(index);
  gate_.expire(now);
  gate_.flush(now);
  return events_;
}

// Before ENet receives anything, because it gives the place of an ended connection to the next newcomer.
void Host::endSlow() {
  for (const ClientId client : std::exchange(slow_, {})) {
    if (const auto index = indexOf(client)) end(*index);
  }
}

void Host::handle(const ENetEvent& event) {
  const std::size_t index = event.peer->incomingPeerID;
  Connection& connection = connections_[index];
  if (event.type == ENET_EVENT_TYPE_CONNECT) {
    connect(connection, *event.peer);
  } else if (event.type == ENET_EVENT_TYPE_DISCONNECT) {
    end(index);
  } else if (event.type == ENET_EVENT_TYPE_RECEIVE) {
    packets_.emplace_back(event.packet, enet_packet_destroy);
    if (!connection.client) return;
    const ByteSpan bytes(event.packet->data, event.packet->dataLength);
    events_.push_back({*connection.client, false, bytes});
  }
}

void Host::connect(Connection& connection, ENetPeer& peer) {
  connection.since = now_;
  connection.client = nextClient_++;
  indexes_.emplace(*connection.client, peer.incomingPeerID);
  gate_.confirm(connection.session);
  configurePeer(peer);
  fixSettings(peer);
}

// Maintains one connection: resets its limits, ends it if it has timed out.
void Host::maintain(std::size_t index) {
  Connection& connection = connections_[index];
  ENetPeer& peer = host_->peers[index];
  if (peer.state == ENET_PEER_STATE_DISCONNECTED) {
    if (connection.session.number != 0) end(index);
    return;
  }
  fixSettings(peer);
  connection.noteOutstanding(peer, now_);
  peer.windowSize = static_cast<enet_uint32>(connection.window);
  if (connection.hasTimedOut(rejections(), now_)) end(index);
}

void Host::end(std::size_t index) {
  Connection& connection = connections_[index];
  if (connection.client) {
    indexes_.erase(*connection.client);
    events_.push_back({*connection.client, true, {}});
  }
  enet_peer_reset(&host_->peers[index]);
  gate_.close(connection.session);
  connection = Connection(now_);
}

std::optional<std::size_t> Host::indexOf(ClientId client) const {
  const auto found = indexes_.find(client);
  return found == indexes_.end() ? std::nullopt : std::optional(found->second);
}

void Host::admit(ClientId client) {
  if (const auto index = indexOf(client)) connections_[*index].admitted = true;
}

void Host::send(ClientId client, bool reliable, std::span<const std::uint8_t> message) {
  const auto index = indexOf(client);
  if (!index) return;
  if (!reliable || roomOf(host_->peers[*index]) > 0) return sendMessage(host_->peers[*index], message, reliable);
  if (connections_[*index].closing) return;
  ++rejections().slow;
  connections_[*index].closing = true;
  slow_.push_back(client);
}

std::size_t Host::room(ClientId client) const {
  const auto index = indexOf(client);
  return index ? roomOf(host_->peers[*index]) : 0;
}

std::uint32_t Host::roundTripMs(ClientId client) const {
  const auto index = indexOf(client);
  return index ? host_->peers[*index].roundTripTime : 0;
}

void Host::close(ClientId client, Time now) {
  const auto index = indexOf(client);
  if (!index) return;
  now_ = now;
  const EnetScope scope(*this, now);
  Connection& connection = connections_[*index];
  connection.admitted = false;
  connection.closing = true;
  connection.since = now;
  enet_peer_disconnect_later(&host_->peers[*index], 0);
}

void Host::flush(Time now) {
  now_ = now;
  const EnetScope scope(*this, now);
  enet_host_flush(host_.get());
  gate_.flush(now);
}

IpAddress Host::addressOf(ClientId client) const {
  const auto index = indexOf(client);
  return index ? gate_.addressOf(connections_[*index].session) : IpAddress{};
}

bool Host::isOpen(ClientId client) const {
  const auto index = indexOf(client);
  return index && !connections_[*index].closing;
}

bool Host::empty() const {
  return std::all_of(connections_.begin(), connections_.end(),
                     [](const Connection& connection) { return connection.session.number == 0; });
}

}  // namespace platon
