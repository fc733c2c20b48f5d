#include "protocol/transport/server_gate.h"

#include <sodium.h>

#include <algorithm>

#include "protocol/transport/control.h"

namespace platon {
namespace {

constexpr Moment kChallengeInterval = std::chrono::milliseconds(100);

// Handshakes of the server, of one site and of one household. One costs about 0.2 ms.
constexpr double kHandshakesPerSecond = 500;
constexpr double kHandshakeBurst = 64;
constexpr double kSitePerSecond = 8;
constexpr double kSiteBurst = 32;
constexpr double kHouseholdPerSecond = 2;
constexpr double kHouseholdBurst = 8;
constexpr double kQueriesPerSecond = 1000;
constexpr double kQueryBurst = 100;
constexpr std::uint32_t kMaxSessions = 4095;  // ENet's limit

CryptoKey randomKey() {
  CryptoKey key;
  randombytes_buf(key.data(), key.size());
  return key;
}

PathChallenge randomChallenge() {
  PathChallenge challenge;
  randombytes_buf(challenge.data(), challenge.size());
  return challenge;
}

bool isAnswer(ByteSpan content, const PathChallenge& challenge) {
  return content.size() == 1 + challenge.size() &&
         sodium_memcmp(content.data() + 1, challenge.data(), challenge.size()) == 0;
}

// False for an address that the system cannot send to, or that reaches more than one receiver.
bool canAnswer(const SocketAddress& address) {
  if (address.port == 0) return false;
  if (!address.ip.isIpv4()) return address.ip.bytes[0] != 0xff && address.ip != IpAddress{};
  const std::uint8_t network = address.ip.ipv4()[0];
  return network != 0 && network < 224;
}

}  // namespace

ServerGate::ServerGate(std::unique_ptr<DatagramSocket> socket, const ServerIdentity& identity,
                       const GateSettings& settings, Moment now)
    : socket_(std::move(socket)),
      identity_(identity),
      settings_(settings),
      cookies_(randomKey()),
      sessions_(std::min(settings.sessions, kMaxSessions)),
      usedKeys_(CookieJar::kEpoch),
      handshakes_(kHandshakesPerSecond, kHandshakeBurst, now),
      queries_(kQueriesPerSecond, kQueryBurst, now),
      households_(kHouseholdPerSecond, kHouseholdBurst, randomKey(), now),
      sites_(kSitePerSecond, kSiteBurst, randomKey(), now),
      nextNumber_(settings.firstNumber) {}

std::optional<ServerGate::Received> ServerGate::receive(Moment now) {
  for (; left_ > 0; --left_) {
    const std::optional<Datagram> datagram = socket_->receive(now);
    if (!datagram) return std::nullopt;
    traffic_.addReceived(datagram->bytes.size());
    if (std::optional<Received> received = take(*datagram, now)) return received;
  }
  return std::nullopt;
}

std::optional<ServerGate::Received> ServerGate::take(const Datagram& datagram, Moment now) {
  const std::size_t size = datagram.bytes.size();
  if (!canAnswer(datagram.peer) || size == 0 || size > kMaxDatagramBytes) {
    ++counters_.malformed;
    return std::nullopt;
  }
  if (SealedChannel::isSealed(datagram.bytes)) return takeSealed(datagram, now);
  takeHandshake(datagram, now);
  return std::nullopt;
}

std::optional<ServerGate::Received> ServerGate::takeSealed(const Datagram& datagram, Moment now) {
  const std::optional<std::uint16_t> slot = SealedChannel::slotOf(datagram.bytes);
  Session* const session = slot && *slot < sessions_.size() ? &sessions_[*slot] : nullptr;
  std::optional<SealedChannel::Content> content;
  if (session != nullptr && session->channel) content = session->channel->open(datagram.bytes);
  if (!content || content->bytes.empty()) {
    ++counters_.seal;
    return std::nullopt;
  }
  session->accept.clear();
  if (content->isControl) {
    takeControl(*session, datagram.peer, content->bytes, now);
    return std::nullopt;
  }
  if (content->isNewest) checkPath(*session, datagram, now);
  return Received{session->id, std::move(content->bytes)};
}

// The client sends from another address, for instance because a router gave it another port. Answers go there only
// after it has shown that it also receives there; otherwise anybody could direct them at others. Or somebody on the
// wire has overtaken its datagram: then it still receives at the old address, and shows that. A household that is full
// gets no challenge: its limit would be worth nothing if sessions could begin elsewhere. A client that does not move is
// asked at times, too: it may have left, and forge its sender to have the server send there.
void ServerGate::checkPath(Session& session, const Datagram& datagram, Moment now) {
  const SocketAddress& sender = datagram.peer;
  const bool strays = sender != session.address;
  if (!strays) session.path.reset();
  if (strays && !session.path) session.path = Path{{}, {}, now};
  if (datagram.bytes.size() < kPathChallengeBytes) return;  // the challenge must not be longer
  const Moment askTime = strays ? Moment(kUnconfirmedPathTime / 2) : Moment(kAskTime);
  const bool isOldDue = now >= servedUntil(session) - askTime && now - session.askedAt >= kChallengeInterval;
  const bool mayMove = strays && !(banCheck_ && banCheck_(sender.ip)) && hasRoomFor(sender.ip, &session);
  const bool isNewDue = mayMove && (!session.challengedAt || now - *session.challengedAt >= kChallengeInterval);
  if (isOldDue && (!isNewDue || session.askedAt <= session.challengedAt)) {
    session.askedAt = now;
    if (!session.ownChallenge) session.ownChallenge = randomChallenge();
    challenge(session, session.address, *session.ownChallenge, now);
  } else if (isNewDue) {
    Path& path = *session.path;
    if (path.address != sender) path.challenge = randomChallenge();
    path.address = sender;
    session.challengedAt = now;
    challenge(session, sender, path.challenge, now);
  }
}

// Until when content is sent to the address of the session.
Moment ServerGate::servedUntil(const Session& session) {
  const Moment shown = session.receivedAt + kShownAddressTime;
  if (!session.path) return shown;
  return std::min(shown, std::max(session.receivedAt, session.path->since) + kUnconfirmedPathTime);
}

void ServerGate::challenge(Session& session, const SocketAddress& receiver, const PathChallenge& challenge,
                           Moment now) {
  Bytes content{kPathChallenge};
  content.insert(content.end(), challenge.begin(), challenge.end());
  sendPlain(receiver, session.channel->seal(content, true), now);
}

// The answer to ownChallenge may come from anywhere: whoever sends it has received at the old address. A client that
// may not move is asked again when the next challenge is due, and is in doubt at its old address as before.
void ServerGate::takeControl(Session& session, const SocketAddress& sender, ByteSpan content, Moment now) {
  if (content[0] != kPathResponse) return;
  if (session.ownChallenge && isAnswer(content, *session.ownChallenge)) {
    session.ownChallenge.reset();
    session.receivedAt = now;
  }
  if (!session.path || session.path->address != sender || !isAnswer(content, session.path->challenge)) return;
  session.path->challenge = randomChallenge();
  if (banCheck_ && banCheck_(sender.ip)) {  // since the challenge
    ++counters_.banned;
    return;
  }
  if (!hasRoomFor(sender.ip, &session) || (moveCheck_ && !moveCheck_(session.id, sender.ip))) {
    ++counters_.full;
    return;
  }
  session.path.reset();
  session.address = sender;
  session.receivedAt = now;
  session.ownChallenge.reset();
}

void ServerGate::send(SessionId id, ByteSpan content, Moment now) {
  if (find(id) == nullptr || content.size() + SealedChannel::kOverhead > kMaxDatagramBytes) return;
  Session& session = sessions_[id.slot];
  if (now >= servedUntil(session)) return;
  sendPlain(session.address, session.channel->seal(content), now);
}

void ServerGate::sendPlain(const SocketAddress& receiver, ByteSpan bytes, Moment now) {
  traffic_.addSent(bytes.size());
  socket_->send(receiver, bytes, now);
}

void ServerGate::confirm(SessionId id) {
  if (find(id) != nullptr) sessions_[id.slot].confirmed = true;
}

void ServerGate::expire(Moment now) {
  for (Session& session : sessions_) {
    if (session.id.number == 0 || session.confirmed || now - session.since < kConfirmTime) continue;
    ++counters_.unconfirmed;
    session = Session{};
  }
}

void ServerGate::close(SessionId id) {
  if (find(id) != nullptr) sessions_[id.slot] = Session{};
}

IpAddress ServerGate::addressOf(SessionId id) const {
  const Session* session = find(id);
  return session == nullptr ? IpAddress{} : session->address.ip;
}

const ServerGate::Session* ServerGate::find(SessionId id) const {
  const bool exists = id.number != 0 && id.slot < sessions_.size() && sessions_[id.slot].id == id;
  return exists ? &sessions_[id.slot] : nullptr;
}

}  // namespace platon
