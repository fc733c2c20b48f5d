#include "client/net/enet_link.h"

#include <sodium.h>

#include <stdexcept>

#include "protocol/label.h"
#include "protocol/limits.h"
#include "protocol/transport/enet_layer.h"
#include "protocol/transport/udp_socket.h"
#include "protocol/version_text.h"

namespace platon {

namespace {

// Round trip assumed until one is measured. A lost connection request is sent again after this time.
constexpr enet_uint32 kInitialRoundTripMs = 100;

// ENet's address of the only session.
constexpr ENetAddress kSession{1, 1};

}  // namespace

EnetLink::EnetLink(const std::vector<SocketAddress>& addresses, const ServerKnowledge& knowledge)
    : EnetLink(std::make_unique<UdpSocket>(), addresses, knowledge) {}

EnetLink::EnetLink(std::unique_ptr<DatagramSocket> socket, const std::vector<SocketAddress>& addresses,
                   const ServerKnowledge& knowledge)
    : gate_(std::move(socket), addresses, knowledge, KeyPair::random()),
      host_(createEnetHost(1, randombytes_random())) {
  if (!host_ || !enetUsesOurCalls())
    throw SocketError("cannot use ENet: this program was linked without its transport");
}

EnetLink::~EnetLink() {
  if (peer_ != nullptr && state_ != State::kClosed) enet_peer_reset(peer_);
}

void EnetLink::sendFromEnet(const ENetAddress&, ByteSpan bytes) { gate_.send(bytes, now_); }

std::optional<EnetPort::Received> EnetLink::receiveForEnet() {
  while (std::optional<Bytes> content = gate_.receive(now_)) {
    if (!accepts(*content)) continue;
    content_ = std::move(*content);
    return Received{kSession, content_};
  }
  return std::nullopt;
}

bool EnetLink::accepts(ByteSpan content) const {
  const std::optional<EnetCommands> commands = readEnetCommands(content, EnetSender::kServer);
  return commands && peer_ != nullptr && commands->peer == peer_->incomingPeerID && areSequencesNear(*commands, *peer_);
}

void EnetLink::service(Time now, const Receiver& receiver) {
  now_ = now;
  gate_.beginRound();
  const EnetScope scope(*this, now);
  if (peer_ == nullptr) shakeHands();
  if (peer_ == nullptr || state_ == State::kClosed) return;
  if (state_ == State::kConnected) fixSettings(*peer_);  // before that, the server must echo the original values
  if (state_ == State::kConnecting) limitRetransmissionTimeout(*peer_, kRequestInterval / std::chrono::milliseconds(1));
  ENetEvent event{};
  for (std::uint32_t events = 0; events < kMaxMessagesPerService; ++events) {
    if (serviceEnet(*host_, event) <= 0) break;
    handle(event, receiver);
  }
  gate_.flush(now);
}

// Until the gate is open, nothing but the handshake can arrive.
void EnetLink::shakeHands() {
  gate_.update(now_);
  gate_.receive(now_);
  gate_.flush(now_);
  if (gate_.state() == ClientGate::State::kOpen) return connect();
  if (gate_.state() == ClientGate::State::kHandshake || state_ == State::kClosed) return;
  refused_ = refusalOf(gate_);
  state_ = State::kClosed;
}

void EnetLink::connect() {
  peer_ = enet_host_connect(host_.get(), &kSession, kChannels, 0);
  if (peer_ == nullptr) throw std::bad_alloc();
  peer_->roundTripTime = kInitialRoundTripMs;
  configurePeer(*peer_);
}

void EnetLink::handle(const ENetEvent& event, const Receiver& receiver) {
  if (event.type == ENET_EVENT_TYPE_CONNECT) {
    state_ = State::kConnected;
  } else if (event.type == ENET_EVENT_TYPE_DISCONNECT) {
    state_ = State::kClosed;
  } else if (event.type == ENET_EVENT_TYPE_RECEIVE) {
    receiver({event.packet->data, event.packet->dataLength});
    enet_packet_destroy(event.packet);
  }
}

void EnetLink::flush(Time now) {
  now_ = now;
  const EnetScope scope(*this, now);
  enet_host_flush(host_.get());
  gate_.flush(now);
}

void EnetLink::send(std::span<const std::uint8_t> message, bool reliable) {
  if (state_ == State::kConnected) sendMessage(*peer_, message, reliable);
}

void EnetLink::close() {
  if (state_ != State::kConnected) return;
  const EnetScope scope(*this, now_);
  enet_peer_disconnect_later(peer_, 0);
}

std::optional<CryptoKey> EnetLink::identity() const {
  return gate_.state() == ClientGate::State::kOpen ? gate_.identity() : std::nullopt;
}

namespace {

std::string bannedText(const std::string& reason) {
  return reason.empty() ? "you are banned from this server" : reason;
}

MessageLink::Refused explain(const Refusal& refusal) {
  switch (refusal.reason) {
    case RefusalReason::kWrongVersion:
      return {otherVersionText("protocol", refusal.version, kProtocolVersion), true};
    case RefusalReason::kFull:
      return {"the server has no free connection: try again later", false};
    case RefusalReason::kAddress:
      return {"the server does not allow more connections from your address", false};
    case RefusalReason::kBanned:
      return {bannedText(visibleLabel(refusal.text)), true};
    case RefusalReason::kPassword:
      return {"the password is wrong", true, true};
  }
  return {"the server refused the connection", true};
}

}  // namespace

MessageLink::Refused refusalOf(const ClientGate& gate) {
  if (gate.state() == ClientGate::State::kNoPassword)
    return {"the server needs a password: write it to a file and name the file after --password-file", true, true};
  if (gate.state() == ClientGate::State::kNoPasswordAsked)
    return {"the server needs no password: join without one if that is right", true};
  if (gate.state() == ClientGate::State::kAnotherIdentity)
    return {"the server is not the one that this program knows at " + gate.server().text() +
                ": either its owner gave it a new key, or somebody answers in its place. If you trust it, remove its "
                "line from "
                "the file known_servers",
            true};
  return explain(*gate.refusal());
}

ServerLinks enetLinks(const ServerAddress& server, const std::optional<ServerAddress>& relay) {
  const ServerAddress target = relay.value_or(server);
  return {server.text(), [addresses = resolve(target.host, target.port)](const ServerKnowledge& knowledge) {
            return std::make_unique<EnetLink>(addresses, knowledge);
          }};
}

}  // namespace platon
