#include "protocol/transport/server_admission.h"

#include <algorithm>
#include <array>
#include <utility>

#include <sodium.h>

#include "protocol/limits.h"

namespace platon {
namespace {

std::uint64_t epochAt(Time now) { return static_cast<std::uint64_t>(now / CookieJar::kEpoch); }

template <class Number>
void mix(crypto_generichash_state& state, Number value) {
  std::array<std::uint8_t, sizeof(Number)> bytes;
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(value >> (8 * i));
  crypto_generichash_update(&state, bytes.data(), bytes.size());
}

}  // namespace

Cookie CookieJar::makeFor(std::uint64_t epoch, const SocketAddress& client, const CryptoKey& clientKey) const {
  Cookie cookie;
  cookie[0] = static_cast<std::uint8_t>(epoch);
  crypto_generichash_state state;
  crypto_generichash_init(&state, secret_.data(), secret_.size(), cookie.size() - 1);
  mix(state, epoch);
  crypto_generichash_update(&state, client.ip.bytes.data(), client.ip.bytes.size());
  mix(state, client.port);
  crypto_generichash_update(&state, clientKey.data(), clientKey.size());
  crypto_generichash_final(&state, cookie.data() + 1, cookie.size() - 1);
  return cookie;
}

Cookie CookieJar::make(const SocketAddress& client, const CryptoKey& clientKey, Time now) const {
  return makeFor(epochAt(now), client, clientKey);
}

bool CookieJar::isValid(const Cookie& cookie, const SocketAddress& client, const CryptoKey& clientKey, Time now) const {
  std::uint64_t epoch = epochAt(now);
  if (cookie[0] != static_cast<std::uint8_t>(epoch)) --epoch;
  const Cookie expected = makeFor(epoch, client, clientKey);
  return sodium_memcmp(cookie.data(), expected.data(), cookie.size()) == 0;
}

namespace {

constexpr auto kVersion = static_cast<std::uint16_t>(kProtocolVersion);

// Handshakes of the server, of one site and of one household. One costs about 0.2 ms.
constexpr double kHandshakesPerSecond = 500;
constexpr double kHandshakeBurst = 64;
constexpr double kSitePerSecond = 8;
constexpr double kSiteBurst = 32;
constexpr double kHouseholdPerSecond = 2;
constexpr double kHouseholdBurst = 8;
constexpr double kQueriesPerSecond = 1000;
constexpr double kQueryBurst = 100;

CryptoKey randomKey() {
  CryptoKey key;
  randombytes_buf(key.data(), key.size());
  return key;
}

}  // namespace

ServerAdmission::ServerAdmission(const ServerIdentity& identity, const GateSettings& settings, const GateRules& rules,
                                 CountedSocket& socket, ServerSessions& sessions, Rejections& rejections, Time now)
    : identity_(identity),
      presharedKey_(settings.presharedKey),
      needsPassword_(settings.needsPassword),
      rules_(rules),
      socket_(socket),
      sessions_(sessions),
      rejections_(rejections),
      cookies_(randomKey()),
      usedKeys_(CookieJar::kEpoch),
      handshakes_(kHandshakesPerSecond, kHandshakeBurst, now),
      queries_(kQueriesPerSecond, kQueryBurst, now),
      households_(kHouseholdPerSecond, kHouseholdBurst, randomKey(), now),
      sites_(kSitePerSecond, kSiteBurst, randomKey(), now) {}

void ServerAdmission::receive(const Datagram& datagram, Time now) {
  const std::optional<HandshakeHead> head = readHead(datagram.bytes);
  if (head && head->kind == HandshakeKind::kKnock) return answerKnock(datagram, now);
  if (head && head->kind == HandshakeKind::kOpen) return answerOpen(datagram, now);
  if (head && head->kind == HandshakeKind::kQuery) return answerQuery(datagram, now);
  ++rejections_.malformed;
}

void ServerAdmission::answerKnock(const Datagram& datagram, Time now) {
  const std::optional<Knock> knock = decodeKnock(datagram.bytes);
  if (!knock) {
    ++rejections_.malformed;
    return;
  }
  if (knock->version != kVersion) {
    ++rejections_.version;
    return refuse(datagram, knock->clientKey, RefusalReason::kWrongVersion, "", now);
  }
  CookieReply reply{echoOf(knock->clientKey), needsPassword_, identity_.publicKey(), {}};
  reply.cookie = cookies_.make(datagram.peer, knock->clientKey, now);
  socket_.send(datagram.peer, encode(reply), now);
}

void ServerAdmission::answerQuery(const Datagram& datagram, Time now) {
  const std::optional<Query> query = decodeQuery(datagram.bytes);
  if (!query || !queries_.take(1, now)) {
    ++(query ? rejections_.queries : rejections_.malformed);
    return;
  }
  Info info = info_;
  info.version = kVersion;
  info.nonce = query->nonce;
  info.identity = identity_.publicKey();
  info.needsPassword = needsPassword_;
  socket_.send(datagram.peer, encode(info), now);
}

void ServerAdmission::answerOpen(const Datagram& datagram, Time now) {
  const std::optional<Open> open = decodeOpen(datagram.bytes);
  if (!open) {
    ++rejections_.malformed;
    return;
  }
  const CryptoKey clientKey = open->clientKey();
  if (!cookies_.isValid(open->cookie, datagram.peer, clientKey, now)) {
    ++rejections_.cookie;
    return;
  }
  if (sessions_.repeatAccept(datagram.peer, clientKey, now) || !mayExchange(datagram, *open, now)) return;
  const std::optional<std::uint16_t> slot = sessions_.freeSlot();
  if (!slot) {
    ++rejections_.full;
    return refuse(datagram, clientKey, RefusalReason::kFull, "", now);
  }
  if (const std::optional<ServerSessions::Agreement> agreement = exchange(*open, *slot)) {
    usedKeys_.add(clientKey, now);
    return sessions_.begin(*slot, datagram.peer, *agreement, now);
  }
  ++rejections_.password;
  if (needsPassword_) refuse(datagram, clientKey, RefusalReason::kPassword, "", now);
}

// All that is cheaper than the key exchange. The address is proved: it may be told why, and charged.
bool ServerAdmission::mayExchange(const Datagram& datagram, const Open& open, Time now) {
  const CryptoKey clientKey = open.clientKey();
  if (usedKeys_.contains(clientKey, now)) {
    ++rejections_.cookie;
    return false;
  }
  const IpAddress& ip = datagram.peer.ip;
  if (!takeBudget(ip, now)) {
    ++rejections_.handshakes;
    return false;
  }
  if (const auto ban = rules_.ban ? rules_.ban(ip) : std::nullopt) {
    ++rejections_.banned;
    if (rules_.banned) rules_.banned(ip);
    refuse(datagram, clientKey, RefusalReason::kBanned, *ban, now);
    return false;
  }
  if (!sessions_.hasRoomFor(ip)) {
    ++rejections_.full;
    refuse(datagram, clientKey, RefusalReason::kAddress, "", now);
    return false;
  }
  return true;
}

// An owner of many households, as every connection to the internet by IPv6 has them, must not use up what all newcomers
// share. What its household or its site refuses takes nothing: beyond the budget of their site, its households would
// drain the buckets of all others; beyond its own, a household would drain that of its site. What only the budget of
// the server refuses is charged to both.
bool ServerAdmission::takeBudget(const IpAddress& client, Time now) {
  if (client.isLoopback()) return handshakes_.take(1, now);
  if (!households_.holds(client.household(), now) || !sites_.holds(client.site(), now)) return false;
  households_.take(client.household(), now);
  sites_.take(client.site(), now);
  return handshakes_.take(1, now);
}

// Nothing if the client does not know the password.
std::optional<ServerSessions::Agreement> ServerAdmission::exchange(const Open& open, std::uint16_t slot) const {
  NoiseExchange exchange(prologueOf(identity_.publicKey()), identity_.exchangeKeys().publicKey, presharedKey_);
  if (!exchange.readFirst(identity_.exchangeKeys(), open.exchange)) return std::nullopt;
  const std::array<std::uint8_t, 2> payload{static_cast<std::uint8_t>(slot), static_cast<std::uint8_t>(slot >> 8)};
  KeyPair ephemeral = KeyPair::random();
  const Bytes message = exchange.writeSecond(ephemeral, payload);
  wipe(ephemeral.secretKey);
  if (message.empty()) return std::nullopt;
  Accept accept{echoOf(open.clientKey()), {}};
  std::copy(message.begin(), message.end(), accept.exchange.begin());
  return ServerSessions::Agreement{open.clientKey(), exchange.split(), encode(accept)};
}

void ServerAdmission::refuse(const Datagram& datagram, const CryptoKey& clientKey, RefusalReason reason,
                             const std::string& text, Time now) {
  socket_.send(datagram.peer, encode(Refusal{kVersion, echoOf(clientKey), reason, text}), now);
}

}  // namespace platon
