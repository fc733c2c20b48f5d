#include "tests/fuzz/handshake_world.h"

#include <algorithm>

#include "protocol/limits.h"
#include "tests/fuzz/handshake_forms.h"

namespace platon::fuzz {
namespace {

using State = ClientGate::State;

template <class Array>
bool isIn(const std::vector<Accept>& accepts, const Array& exchange) {
  return std::any_of(accepts.begin(), accepts.end(), [&](const Accept& each) { return each.exchange == exchange; });
}

}  // namespace

const std::vector<SocketAddress>& HandshakeWorld::addresses() {
  static const std::vector<SocketAddress> all{
      addressAt("192.0.2.1", 4000), addressAt("2001:db8::1", 4000), addressAt("2001:db8::2", 4000),
      addressAt("192.0.2.1", 4001), addressAt("203.0.113.9", 999),  addressAt("2001:db8:0:1::1", 5),
      addressAt("127.0.0.1", 6000), addressAt("::1", 6000),         server(),
      addressAt("198.51.100.2", 0), addressAt("224.0.0.1", 5),      addressAt("::", 5)};
  return all;
}

const SocketAddress& HandshakeWorld::server() {
  static const SocketAddress address = addressAt("198.51.100.1", 7777);
  return address;
}

const CryptoKey& HandshakeWorld::identity() {
  static const CryptoKey key = ServerIdentity(kSecret).publicKey();
  return key;
}

HandshakeWorld::HandshakeWorld(const Setup& setup) : setup_(setup), ownKeys_(KeyPair::random()) {
  network_.setFilter([](const auto&) { return false; });
  if (setup.needsPassword) presharedKey_.fill(7);
  gate_.emplace(network_.socket(server()), identity_,
                GateSettings{setup.sessions, setup.sessionsPerHousehold, presharedKey_, setup.needsPassword}, now_,
                GateRules{.ban = [this](const IpAddress&) {
                  return banned_ ? std::optional<std::string>("a reason") : std::nullopt;
                }});
  clients_.resize(kClients);
  for (std::size_t i = 0; i < kClients; ++i) startClient(clients_[i], addresses()[i]);
}

void HandshakeWorld::startClient(Client& client, const SocketAddress& own) {
  client.keys = KeyPair::random();
  ServerKnowledge knowledge;
  if (setup_.clientsKnowIdentity) knowledge.identity = identity_.publicKey();
  if (setup_.clientsHavePassword) knowledge.password = Password("sesame");
  client.gate = std::make_unique<ClientGate>(network_.socket(own), std::vector{server()}, knowledge, client.keys);
}

void HandshakeWorld::restartClient(std::size_t client) { startClient(clients_[client], addresses()[client]); }

void HandshakeWorld::require(bool holds, const char* law) {
  if (!holds && fault_.empty()) fault_ = law;
}

platon::Bytes HandshakeWorld::nextContent(std::size_t bytes) {
  platon::Bytes content(bytes);
  ++contents_;
  for (std::size_t i = 0; i < sizeof contents_; ++i) content[i] = static_cast<std::uint8_t>(contents_ >> 8 * i);
  return content;
}

void HandshakeWorld::sendFromClient(std::size_t number, std::size_t bytes) {
  Client& client = clients_[number];
  if (client.gate->state() != State::kOpen) return;
  const platon::Bytes content = nextContent(bytes);
  toServer_.insert({client.keys.publicKey, content});
  client.gate->send(content, now_);
}

void HandshakeWorld::sendFromServer(std::size_t number, std::size_t bytes) {
  if (sessions_.empty()) return;
  const ModelSession& session = sessions_[number % sessions_.size()];
  const platon::Bytes content = nextContent(bytes);
  const std::size_t before = sent().size();
  gate_->send(session.id, content, now_);
  const bool mayHoldBack = (session.strayedAt && now_ - *session.strayedAt >= ServerSessions::kUnconfirmedPathTime) ||
                           now_ - session.shownAt >= ServerSessions::kShownAddressTime;
  const bool hasSent = sent().size() == before + 1;
  require(gate_->isOpen(session.id) ? hasSent || mayHoldBack : !hasSent,
          "the server sends to a session that has ended, or nothing to a client that has not moved");
  require(!hasSent || sent().back().to.ip == session.address.ip,
          "the server sends to another address than that of the session");
  toClient_.insert({session.clientKey, content});
}

void HandshakeWorld::confirm(std::size_t number) {
  if (sessions_.empty()) return;
  ModelSession& session = sessions_[number % sessions_.size()];
  gate_->confirm(session.id);
  session.confirmed = !session.closed && gate_->isOpen(session.id);
}

void HandshakeWorld::close(std::size_t number) {
  if (sessions_.empty()) return;
  ModelSession& session = sessions_[number % sessions_.size()];
  session.closed = true;
  gate_->close(session.id);
  require(!gate_->isOpen(session.id), "a closed session is open");
}

void HandshakeWorld::expire() {
  gate_->expire(now_);
  checkSessions({}, 0);
}

platon::Bytes HandshakeWorld::knock() {
  return encode(Knock{static_cast<std::uint16_t>(kProtocolVersion), ownKeys_.publicKey});
}

platon::Bytes HandshakeWorld::openFor(const SocketAddress& client, bool isRight) {
  const auto found = std::find_if(issued_.rbegin(), issued_.rend(), [&](const Issued& each) {
    return each.client == client && each.key == ownKeys_.publicKey;
  });
  if (found == issued_.rend()) return {};
  CryptoKey presharedKey = presharedKey_;
  presharedKey[0] ^= isRight ? 0 : 1;
  NoiseExchange exchange(prologueOf(identity_.publicKey()), identity_.exchangeKeys().publicKey, presharedKey);
  Open open{found->cookie, {}};
  const platon::Bytes message = exchange.writeFirst(ownKeys_, {});
  std::copy(message.begin(), message.end(), open.exchange.begin());
  if (isRight) rightExchanges_.insert(open.exchange);
  if (isRight) ownKeys_ = KeyPair::random();
  return encode(open);
}

// An Open of a client of ours holds the right exchange, unless the server asks for a password.
void HandshakeWorld::noteRequest(ByteSpan datagram) {
  const std::optional<Open> open = decodeOpen(datagram);
  if (!open || setup_.needsPassword) return;
  const bool isOurs = std::any_of(sent().begin(), sent().end(), [&](const DatagramNetwork::Sent& each) {
    const std::optional<Open> other = each.from == server() ? std::nullopt : decodeOpen(each.bytes);
    return other && other->exchange == open->exchange;
  });
  if (isOurs) rightExchanges_.insert(open->exchange);
}

bool HandshakeWorld::mayOpen(const SocketAddress& from, const Open& open) const {
  const bool hasCookie = std::any_of(issued_.begin(), issued_.end(), [&](const Issued& each) {
    return each.client == from && each.key == open.clientKey() && each.cookie == open.cookie &&
           epoch() - each.epoch <= 1;
  });
  return hasCookie && !banned_ && !usedKeys_.contains(open.clientKey()) && rightExchanges_.contains(open.exchange);
}

void HandshakeWorld::deliverToServer(const SocketAddress& from, ByteSpan datagram) {
  fault_ = fault_.empty() ? handshakeFormFault(datagram) : fault_;
  noteRequest(datagram);
  const platon::Bytes bytes(datagram.begin(), datagram.end());  // `datagram` may be one that was sent
  const std::size_t before = sent().size();
  network_.inject(from, server(), bytes);
  gate_->beginRound();
  while (const auto received = gate_->receive(now_)) checkReceived(*received, from);
  checkAnswers(from, bytes, before);
  checkSessions(from, before);
}

// Nothing but one answer, which is no longer than the datagram, to the sender; or a challenge to the address of a
// session.
void HandshakeWorld::checkAnswers(const SocketAddress& from, ByteSpan datagram, std::size_t before) {
  require(sent().size() <= before + 1, "a datagram has several answers");
  if (sent().size() == before) return;
  const platon::Bytes answer = sent().back().bytes;
  const bool isChallenge = SealedChannel::isSealed(answer) && answer.size() == kPathChallengeBytes;
  require((sent().back().to == from && from.port != 0) || (isChallenge && isAddressOfSession(sent().back().to)),
          "an answer goes to somebody else");
  require(answer.size() <= datagram.size(), "an answer is longer than the request");
  noteAnswer(from, datagram, answer);
}

void HandshakeWorld::noteAnswer(const SocketAddress& from, ByteSpan datagram, ByteSpan answer) {
  if (const auto knocked = decodeKnock(datagram)) {
    const auto reply = decodeCookieReply(answer);
    const bool ours = knocked->version == kProtocolVersion;
    require(ours == reply.has_value(), "a knock has a wrong answer");
    if (reply) issued_.push_back({from, knocked->clientKey, reply->cookie, epoch()});
    return;
  }
  if (decodeQuery(datagram)) return require(decodeInfo(answer).has_value(), "a query has a wrong answer");
  if (SealedChannel::isSealed(datagram)) return require(SealedChannel::isSealed(answer), "a seal has a plain answer");
  require(decodeOpen(datagram).has_value(), "a datagram without meaning has an answer");
  if (const auto accept = decodeAccept(answer)) return noteAccept(from, datagram, *accept);
  require(decodeRefusal(answer).has_value(), "an open has a wrong answer");
}

void HandshakeWorld::noteAccept(const SocketAddress& from, ByteSpan datagram, const Accept& accept) {
  if (isIn(accepts_, accept.exchange)) return;  // repeated
  const Open open = *decodeOpen(datagram);
  require(mayOpen(from, open), "a session begins without a cookie, or with one that was used, or without the password");
  accepts_.push_back(accept);
  usedKeys_.insert(open.clientKey());
  const auto number = static_cast<std::uint32_t>(sessions_.size() + 1);
  for (std::uint16_t slot = 0; slot < setup_.sessions; ++slot) {
    if (gate_->isOpen({number, slot}))
      sessions_.push_back({{number, slot}, open.clientKey(), from, false, false, now_});
  }
  require(sessions_.size() == number, "an accepted session is not open");
}

// `before`: datagrams that were sent before that of `from` came.
void HandshakeWorld::checkSessions(const SocketAddress& from, std::size_t before) {
  const auto next = static_cast<std::uint32_t>(sessions_.size() + 1);
  for (std::uint16_t slot = 0; slot < setup_.sessions; ++slot) {
    require(!gate_->isOpen({next, slot}), "a session begins that nobody was told of");
  }
  for (ModelSession& session : sessions_) {
    require(gate_->isOpen(session.id) || session.closed || !session.confirmed, "a confirmed session has ended");
    if (!gate_->isOpen(session.id)) continue;
    require(!session.closed, "a closed session is open again");
    require(isWithinHousehold(gate_->addressOf(session.id)), "a household has more sessions than it may have");
    if (gate_->addressOf(session.id) == session.address.ip) continue;
    const auto asked = std::find_if(
        sent().begin(), sent().begin() + static_cast<std::ptrdiff_t>(before),
        [&](auto& each) { return each.from == server() && each.to == from && SealedChannel::isSealed(each.bytes); });
    const bool wasAsked = asked != sent().begin() + static_cast<std::ptrdiff_t>(before);
    require(gate_->addressOf(session.id) == from.ip && wasAsked,
            "a session has moved to an address that was not asked");
    session.address = from;
    session.shownAt = now_;
  }
}

// Whether the household of the address has no more sessions than it may have.
bool HandshakeWorld::isWithinHousehold(const IpAddress& address) const {
  const auto sessions = std::count_if(sessions_.begin(), sessions_.end(), [&](const ModelSession& each) {
    return gate_->isOpen(each.id) && gate_->addressOf(each.id).household() == address.household();
  });
  return address.isLoopback() || sessions <= std::int64_t{setup_.sessionsPerHousehold};
}

bool HandshakeWorld::isAddressOfSession(const SocketAddress& address) const {
  return std::any_of(sessions_.begin(), sessions_.end(),
                     [&](const ModelSession& each) { return gate_->isOpen(each.id) && each.address == address; });
}

void HandshakeWorld::checkReceived(const ServerGate::Received& received, const SocketAddress& from) {
  const auto session = std::find_if(sessions_.begin(), sessions_.end(),
                                    [&](const ModelSession& each) { return each.id == received.session; });
  require(session != sessions_.end() && !session->closed, "a content of no session");
  if (session == sessions_.end()) return;
  if (!session->strayedAt && from != session->address) session->strayedAt = now_;
  require(toServer_.erase({session->clientKey, received.bytes}) == 1, "a content that was not sent, or comes again");
}

void HandshakeWorld::deliverToClient(std::size_t number, const SocketAddress& from, ByteSpan datagram) {
  const auto cookie = decodeCookieReply(datagram);
  if (setup_.clientsHavePassword && cookie && cookie->needsPassword) return;
  fault_ = fault_.empty() ? handshakeFormFault(datagram) : fault_;
  Client& client = clients_[number];
  const State before = client.gate->state();
  const std::size_t sentBefore = sent().size();
  const platon::Bytes bytes(datagram.begin(), datagram.end());
  network_.inject(from, addresses()[number], bytes);
  client.gate->beginRound();
  while (const auto content = client.gate->receive(now_)) {
    require(toClient_.erase({client.keys.publicKey, *content}) == 1,
            "a client gets a content that was not sent, or again");
  }
  require(sent().size() <= sentBefore + (from == server() ? 1 : 0), "a client has too many answers");
  require(sent().size() == sentBefore || sent().back().to == server(), "a client answers somebody else");
  require(from == server() || client.gate->state() == before, "a stranger changes a client");
  const bool isOther = setup_.clientsKnowIdentity && cookie && cookie->identity != identity_.publicKey();
  require(!isOther || sent().size() == sentBefore, "a client goes on with a server that it does not know");
  if (client.gate->state() != before) checkTransition(client, before, bytes);
}

bool HandshakeWorld::wasAccepted(ByteSpan datagram) const {
  const std::optional<Accept> accept = decodeAccept(datagram);
  return accept && isIn(accepts_, accept->exchange);
}

void HandshakeWorld::checkTransition(const Client& client, State before, ByteSpan datagram) {
  require(before == State::kHandshake, "a client leaves a final state");
  const Echo echo = echoOf(client.keys.publicKey);
  const auto cookie = decodeCookieReply(datagram);
  const auto refusal = decodeRefusal(datagram);
  const bool toldOfPassword = cookie && cookie->echo == echo && cookie->needsPassword != setup_.clientsHavePassword;
  switch (client.gate->state()) {
    case State::kHandshake:
      break;
    case State::kOpen:
      require(wasAccepted(datagram), "a client is open that the server has not accepted");
      require(client.gate->identity() == identity_.publicKey(), "a client is open at another server");
      return require(!setup_.clientsHavePassword, "a client with a password joins a server that asks for none");
    case State::kRefused:
      return require(refusal && refusal->echo == echo, "a client is refused by somebody who has not seen its key");
    case State::kNoPasswordAsked:
    case State::kNoPassword:
      return require(toldOfPassword, "a client misses a password, or gives up without a reason");
    case State::kAnotherIdentity:
      return require(setup_.clientsKnowIdentity && cookie && cookie->identity != identity_.publicKey(),
                     "a client does not know its server again");
  }
}

void HandshakeWorld::checkNewcomer() {
  banned_ = false;
  for (std::size_t i = 0; i < sessions_.size(); ++i) close(i);
  wait(std::chrono::minutes(4));  // budgets are full again
  expire();
  const SocketAddress own = addressAt("2001:db8:0:2::1", 4000);
  deliverToServer(own, knock());
  const std::size_t sessions = sessions_.size();
  deliverToServer(own, openFor(own, true));
  require(sessions_.size() == sessions + 1, "a newcomer cannot join");
}

}  // namespace platon::fuzz
