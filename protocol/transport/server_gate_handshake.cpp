#include <algorithm>

#include "protocol/limits.h"
#include "protocol/transport/server_gate.h"

namespace platon {
namespace {

constexpr auto kVersion = static_cast<std::uint16_t>(kProtocolVersion);

// Sessions of a site, in those of a household.
constexpr std::int64_t kHouseholdsPerSite = 4;

}  // namespace

void ServerGate::takeHandshake(const Datagram& datagram, Moment now) {
  const std::optional<HandshakeHead> head = readHead(datagram.bytes);
  if (head && head->kind == HandshakeKind::kKnock) return answerKnock(datagram, now);
  if (head && head->kind == HandshakeKind::kOpen) return answerOpen(datagram, now);
  if (head && head->kind == HandshakeKind::kQuery) return answerQuery(datagram, now);
  ++counters_.malformed;
}

void ServerGate::answerKnock(const Datagram& datagram, Moment now) {
  const std::optional<Knock> knock = decodeKnock(datagram.bytes);
  if (!knock) {
    ++counters_.malformed;
    return;
  }
  if (knock->version != kVersion) {
    ++counters_.version;
    return refuse(datagram, knock->clientKey, RefusalReason::kWrongVersion, "", now);
  }
  CookieReply reply{echoOf(knock->clientKey), settings_.needsPassword, identity_.publicKey(), {}};
  reply.cookie = cookies_.make(datagram.peer, knock->clientKey, now);
  sendPlain(datagram.peer, encode(reply), now);
}

void ServerGate::answerQuery(const Datagram& datagram, Moment now) {
  const std::optional<Query> query = decodeQuery(datagram.bytes);
  if (!query || !queries_.take(1, now)) {
    ++(query ? counters_.queries : counters_.malformed);
    return;
  }
  Info info = info_;
  info.version = kVersion;
  info.nonce = query->nonce;
  info.identity = identity_.publicKey();
  info.needsPassword = settings_.needsPassword;
  sendPlain(datagram.peer, encode(info), now);
}

void ServerGate::answerOpen(const Datagram& datagram, Moment now) {
  const std::optional<Open> open = decodeOpen(datagram.bytes);
  if (!open) {
    ++counters_.malformed;
    return;
  }
  const CryptoKey clientKey = open->clientKey();
  if (!cookies_.isValid(open->cookie, datagram.peer, clientKey, now)) {
    ++counters_.cookie;
    return;
  }
  if (repeatAccept(datagram.peer, clientKey, now) || !mayExchange(datagram, *open, now)) return;
  Session* const session = placeForSession();
  if (session == nullptr) {
    ++counters_.full;
    return refuse(datagram, clientKey, RefusalReason::kFull, "", now);
  }
  if (startSession(*session, datagram.peer, *open, now)) return;
  ++counters_.password;
  if (settings_.needsPassword) refuse(datagram, clientKey, RefusalReason::kPassword, "", now);
}

// An Accept that was lost.
bool ServerGate::repeatAccept(const SocketAddress& client, const CryptoKey& clientKey, Moment now) {
  const auto found = std::find_if(sessions_.begin(), sessions_.end(), [&](const Session& session) {
    return session.id.number != 0 && session.clientKey == clientKey;
  });
  if (found == sessions_.end()) return false;
  if (!found->accept.empty() && found->address == client) sendPlain(client, found->accept, now);
  return true;
}

// All that is cheaper than the key exchange. The address is proved: it may be told why, and charged.
bool ServerGate::mayExchange(const Datagram& datagram, const Open& open, Moment now) {
  const CryptoKey clientKey = open.clientKey();
  if (usedKeys_.contains(clientKey, now)) {
    ++counters_.cookie;
    return false;
  }
  const IpAddress& ip = datagram.peer.ip;
  if (!takeBudget(ip, now)) {
    ++counters_.handshakes;
    return false;
  }
  if (const auto ban = banCheck_ ? banCheck_(ip) : std::nullopt) {
    ++counters_.banned;
    if (banNotice_) banNotice_(ip);
    refuse(datagram, clientKey, RefusalReason::kBanned, *ban, now);
    return false;
  }
  if (!hasRoomFor(ip)) {
    ++counters_.full;
    refuse(datagram, clientKey, RefusalReason::kAddress, "", now);
    return false;
  }
  return true;
}

// An owner of many households, as every connection to the internet by IPv6 has them, must not use up what all newcomers
// share. What its household or its site refuses takes nothing: beyond the budget of their site, its households would
// drain the buckets of all others; beyond its own, a household would drain that of its site. What only the budget of
// the server refuses is charged to both.
bool ServerGate::takeBudget(const IpAddress& client, Moment now) {
  if (client.isLoopback()) return handshakes_.take(1, now);
  if (!households_.holds(client.household(), now) || !sites_.holds(client.site(), now)) return false;
  households_.take(client.household(), now);
  sites_.take(client.site(), now);
  return handshakes_.take(1, now);
}

// Whether a session, or `moving`, may be at this address.
bool ServerGate::hasRoomFor(const IpAddress& client, const Session* moving) const {
  if (client.isLoopback()) return true;
  const auto countOf = [this, moving](auto&& isSame) {
    return std::count_if(sessions_.begin(), sessions_.end(), [&](const Session& session) {
      return session.id.number != 0 && &session != moving && isSame(session.address.ip);
    });
  };
  const std::int64_t most = settings_.sessionsPerHousehold;
  return countOf([&](const IpAddress& other) { return other.household() == client.household(); }) < most &&
         countOf([&](const IpAddress& other) { return other.site() == client.site(); }) < kHouseholdsPerSite * most;
}

// A free place; if there is none, that of the session that has waited longest to be confirmed.
ServerGate::Session* ServerGate::placeForSession() {
  Session* oldest = nullptr;
  for (Session& session : sessions_) {
    if (session.id.number == 0) return &session;
    if (!session.confirmed && (oldest == nullptr || session.since < oldest->since)) oldest = &session;
  }
  return oldest;
}

// False if the client does not know the password: the place stays as it is.
bool ServerGate::startSession(Session& session, const SocketAddress& client, const Open& open, Moment now) {
  NoiseExchange exchange(prologueOf(identity_.publicKey()), identity_.exchangeKeys().open, settings_.presharedKey);
  if (!exchange.readFirst(identity_.exchangeKeys(), open.exchange)) return false;
  const auto slot = static_cast<std::uint16_t>(&session - sessions_.data());
  const std::array<std::uint8_t, 2> payload{static_cast<std::uint8_t>(slot), static_cast<std::uint8_t>(slot >> 8)};
  KeyPair ephemeral = KeyPair::random();
  const Bytes message = exchange.writeSecond(ephemeral, payload);
  wipe(ephemeral.secret);
  if (message.empty()) return false;
  Accept accept{echoOf(open.clientKey()), {}};
  std::copy(message.begin(), message.end(), accept.exchange.begin());
  session = Session{};
  session.id = {nextNumber_, slot};
  nextNumber_ = std::max(nextNumber_ + 1, 1u);
  session.address = client;
  session.receivedAt = now;
  session.channel.emplace(SealedChannel::Side::kServer, exchange.split(), slot);
  session.clientKey = open.clientKey();
  session.accept = encode(accept);
  session.since = now;
  usedKeys_.add(session.clientKey, now);
  sendPlain(client, session.accept, now);
  return true;
}

void ServerGate::refuse(const Datagram& datagram, const CryptoKey& clientKey, RefusalReason reason,
                        const std::string& text, Moment now) {
  sendPlain(datagram.peer, encode(Refusal{kVersion, echoOf(clientKey), reason, text}), now);
}

}  // namespace platon
