#include "protocol/transport/client_gate.h"

#include <algorithm>

#include "protocol/limits.h"
#include "protocol/transport/sealed_channel.h"
#include "protocol/transport/server_identity.h"

namespace platon {

ClientGate::ClientGate(std::unique_ptr<DatagramSocket> socket, std::vector<SocketAddress> servers,
                       ServerKnowledge knowledge, const KeyPair& ephemeral)
    : socket_(std::move(socket)),
      servers_(std::move(servers)),
      knowledge_(std::move(knowledge)),
      ephemeral_(ephemeral),
      request_(encode(Knock{static_cast<std::uint16_t>(kProtocolVersion), ephemeral.publicKey})) {}

void ClientGate::update(Time now) {
  if (state_ != State::kHandshake || (sentAt_ && now - *sentAt_ < kRepeatInterval)) return;
  sentAt_ = now;
  for (const SocketAddress& server : servers_) socket_.send(server, request_, now);
}

std::optional<Bytes> ClientGate::receive(Time now) {
  for (; left_ > 0; --left_) {
    const std::optional<Datagram> datagram = socket_.receive(now);
    if (!datagram) return std::nullopt;
    const std::size_t size = datagram->bytes.size();
    if (size == 0 || size > kMaxDatagramBytes || !isServer(datagram->peer)) continue;
    if (std::optional<Bytes> content = take(*datagram, now)) return content;
  }
  return std::nullopt;
}

bool ClientGate::isServer(const SocketAddress& address) const {
  return std::find(servers_.begin(), servers_.end(), address) != servers_.end();
}

std::optional<Bytes> ClientGate::take(const Datagram& datagram, Time now) {
  if (SealedChannel::isSealed(datagram.bytes)) return takeSealed(datagram.bytes, now);
  if (state_ == State::kHandshake) takeHandshake(datagram, now);
  return std::nullopt;
}

void ClientGate::takeHandshake(const Datagram& datagram, Time now) {
  if (const auto reply = decodeCookieReply(datagram.bytes)) return takeCookie(datagram.peer, *reply, now);
  if (const auto accept = decodeAccept(datagram.bytes)) return takeAccept(*accept);
  if (const auto refusal = decodeRefusal(datagram.bytes)) return takeRefusal(*refusal);
}

void ClientGate::takeCookie(const SocketAddress& server, const CookieReply& reply, Time now) {
  if (exchange_ || reply.echo != echoOf(ephemeral_.publicKey)) return;
  const std::optional<CryptoKey> serverKey = exchangeKeyOf(reply.identity);
  if (!serverKey) return;
  identity_ = reply.identity;
  if (knowledge_.identity && *knowledge_.identity != reply.identity) {
    state_ = State::kAnotherIdentity;
    return;
  }
  // Whoever answers first could otherwise say that no password is needed, and be joined without any proof.
  if (reply.needsPassword == knowledge_.password.empty()) {
    state_ = reply.needsPassword ? State::kNoPassword : State::kNoPasswordAsked;
    return;
  }
  const CryptoKey presharedKey = reply.needsPassword ? knowledge_.password.keyFor(reply.identity) : CryptoKey{};
  exchange_.emplace(prologueOf(reply.identity), *serverKey, presharedKey);
  Open open{reply.cookie, {}};
  const Bytes message = exchange_->writeFirst(ephemeral_, {});
  if (message.size() != open.exchange.size()) return;
  std::copy(message.begin(), message.end(), open.exchange.begin());
  request_ = encode(open);
  servers_ = {server};
  sentAt_ = now;
  socket_.send(server, request_, now);
}

void ClientGate::takeAccept(const Accept& accept) {
  if (!exchange_ || accept.echo != echoOf(ephemeral_.publicKey)) return;
  NoiseExchange exchange = *exchange_;  // a forged answer must not spoil it
  const std::optional<Bytes> payload = exchange.readSecond(accept.exchange);
  if (!payload || payload->size() != 2) return;
  const auto slot = static_cast<std::uint16_t>((*payload)[0] | (*payload)[1] << 8);
  channel_.emplace(SealedChannel::Side::kClient, exchange.split(), slot);
  exchange_.reset();
  wipe(ephemeral_.secretKey);
  state_ = State::kOpen;
}

void ClientGate::takeRefusal(const Refusal& refusal) {
  if (refusal.echo != echoOf(ephemeral_.publicKey)) return;
  refusal_ = refusal;
  state_ = State::kRefused;
}

std::optional<Bytes> ClientGate::takeSealed(ByteSpan datagram, Time now) {
  if (!channel_) return std::nullopt;
  std::optional<SealedChannel::Content> content = channel_->open(datagram);
  if (!content || content->bytes.empty()) return std::nullopt;
  if (!content->isControl) return std::move(content->bytes);
  if (content->bytes[0] == kPathChallenge) {
    content->bytes[0] = kPathResponse;
    sendControl(content->bytes, now);
  }
  return std::nullopt;
}

void ClientGate::send(ByteSpan content, Time now) {
  if (!channel_ || content.size() + SealedChannel::kOverhead > kMaxDatagramBytes) return;
  socket_.send(servers_.front(), channel_->seal(content), now);
}

void ClientGate::sendControl(ByteSpan content, Time now) {
  if (channel_) socket_.send(servers_.front(), channel_->seal(content, true), now);
}

}  // namespace platon
