#include "protocol/transport/server_sessions.h"

#include <algorithm>
#include <utility>

#include <sodium.h>

namespace platon {
namespace {

constexpr Time kChallengeInterval = std::chrono::milliseconds(100);
constexpr std::uint32_t kMaxSessions = 4095;  // ENet's limit

// Sessions of a site, in those of a household.
constexpr std::int64_t kHouseholdsPerSite = 4;

PathChallenge randomChallenge() {
  PathChallenge challenge;
  randombytes_buf(challenge.data(), challenge.size());
  return challenge;
}

bool isAnswer(ByteSpan content, const PathChallenge& challenge) {
  return content.size() == 1 + challenge.size() &&
         sodium_memcmp(content.data() + 1, challenge.data(), challenge.size()) == 0;
}

}  // namespace

ServerSessions::ServerSessions(const GateSettings& settings, const GateRules& rules, CountedSocket& socket,
                               Rejections& rejections)
    : rules_(rules),
      socket_(socket),
      rejections_(rejections),
      sessions_(std::min(settings.sessions, kMaxSessions)),
      sessionsPerHousehold_(settings.sessionsPerHousehold),
      nextNumber_(settings.firstNumber) {}

std::optional<std::uint16_t> ServerSessions::freeSlot() const {
  const Session* oldest = nullptr;
  for (const Session& session : sessions_) {
    if (session.id.number == 0) return static_cast<std::uint16_t>(&session - sessions_.data());
    if (!session.confirmed && (oldest == nullptr || session.since < oldest->since)) oldest = &session;
  }
  return oldest == nullptr ? std::nullopt : std::optional(oldest->id.slot);
}

// Whether a session, or `moving`, may be at this address.
bool ServerSessions::hasRoomFor(const IpAddress& client, const Session* moving) const {
  if (client.isLoopback()) return true;
  const auto countOf = [this, moving](auto&& isSame) {
    return std::count_if(sessions_.begin(), sessions_.end(), [&](const Session& session) {
      return session.id.number != 0 && &session != moving && isSame(session.address.ip);
    });
  };
  const std::int64_t most = sessionsPerHousehold_;
  return countOf([&](const IpAddress& other) { return other.household() == client.household(); }) < most &&
         countOf([&](const IpAddress& other) { return other.site() == client.site(); }) < kHouseholdsPerSite * most;
}

void ServerSessions::begin(std::uint16_t slot, const SocketAddress& client, const Agreement& agreement, Time now) {
  Session& session = sessions_[slot];
  session = Session{};
  session.id = {nextNumber_, slot};
  nextNumber_ = std::max(nextNumber_ + 1, 1u);
  session.address = client;
  session.receivedAt = now;
  session.channel.emplace(SealedChannel::Side::kServer, agreement.keys, slot);
  session.clientKey = agreement.clientKey;
  session.accept = agreement.accept;
  session.since = now;
  socket_.send(client, session.accept, now);
}

bool ServerSessions::repeatAccept(const SocketAddress& client, const CryptoKey& clientKey, Time now) {
  const auto found = std::find_if(sessions_.begin(), sessions_.end(), [&](const Session& session) {
    return session.id.number != 0 && session.clientKey == clientKey;
  });
  if (found == sessions_.end()) return false;
  if (!found->accept.empty() && found->address == client) socket_.send(client, found->accept, now);
  return true;
}

std::optional<ServerSessions::Received> ServerSessions::receive(const Datagram& datagram, Time now) {
  const std::optional<std::uint16_t> slot = SealedChannel::slotOf(datagram.bytes);
  Session* const session = slot && *slot < sessions_.size() ? &sessions_[*slot] : nullptr;
  std::optional<SealedChannel::Content> content;
  if (session != nullptr && session->channel) content = session->channel->open(datagram.bytes);
  if (!content || content->bytes.empty()) {
    ++rejections_.seal;
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
void ServerSessions::checkPath(Session& session, const Datagram& datagram, Time now) {
  const SocketAddress& sender = datagram.peer;
  const bool strays = sender != session.address;
  if (!strays) session.path.reset();
  if (strays && !session.path) session.path = Path{{}, {}, now};
  if (datagram.bytes.size() < kPathChallengeBytes) return;  // the challenge must not be longer
  const Time askTime = strays ? Time(kUnconfirmedPathTime / 2) : Time(kAskTime);
  const bool isOldDue = now >= servedUntil(session) - askTime && now - session.askedAt >= kChallengeInterval;
  const bool mayMove = strays && !isBanned(sender.ip) && hasRoomFor(sender.ip, &session);
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
Time ServerSessions::servedUntil(const Session& session) {
  const Time shown = session.receivedAt + kShownAddressTime;
  if (!session.path) return shown;
  return std::min(shown, std::max(session.receivedAt, session.path->since) + kUnconfirmedPathTime);
}

void ServerSessions::challenge(Session& session, const SocketAddress& receiver, const PathChallenge& challenge,
                               Time now) {
  Bytes content{kPathChallenge};
  content.insert(content.end(), challenge.begin(), challenge.end());
  socket_.send(receiver, session.channel->seal(content, true), now);
}

// The answer to ownChallenge may come from anywhere: whoever sends it has received at the old address. A client that
// may not move is asked again when the next challenge is due, and is in doubt at its old address as before.
void ServerSessions::takeControl(Session& session, const SocketAddress& sender, ByteSpan content, Time now) {
  if (content[0] != kPathResponse) return;
  if (session.ownChallenge && isAnswer(content, *session.ownChallenge)) {
    session.ownChallenge.reset();
    session.receivedAt = now;
  }
  if (!session.path || session.path->address != sender || !isAnswer(content, session.path->challenge)) return;
  session.path->challenge = randomChallenge();
  if (isBanned(sender.ip)) {  // since the challenge
    ++rejections_.banned;
    return;
  }
  if (!hasRoomFor(sender.ip, &session) || (rules_.mayMove && !rules_.mayMove(session.id, sender.ip))) {
    ++rejections_.full;
    return;
  }
  session.path.reset();
  session.address = sender;
  session.receivedAt = now;
  session.ownChallenge.reset();
}

void ServerSessions::send(SessionId id, ByteSpan content, Time now) {
  if (find(id) == nullptr || content.size() + SealedChannel::kOverhead > kMaxDatagramBytes) return;
  Session& session = sessions_[id.slot];
  if (now >= servedUntil(session)) return;
  socket_.send(session.address, session.channel->seal(content), now);
}

void ServerSessions::confirm(SessionId id) {
  if (find(id) != nullptr) sessions_[id.slot].confirmed = true;
}

void ServerSessions::expire(Time now) {
  for (Session& session : sessions_) {
    if (session.id.number == 0 || session.confirmed || now - session.since < kConfirmTime) continue;
    ++rejections_.unconfirmed;
    session = Session{};
  }
}

void ServerSessions::close(SessionId id) {
  if (find(id) != nullptr) sessions_[id.slot] = Session{};
}

IpAddress ServerSessions::addressOf(SessionId id) const {
  const Session* session = find(id);
  return session == nullptr ? IpAddress{} : session->address.ip;
}

const ServerSessions::Session* ServerSessions::find(SessionId id) const {
  const bool exists = id.number != 0 && id.slot < sessions_.size() && sessions_[id.slot].id == id;
  return exists ? &sessions_[id.slot] : nullptr;
}

}  // namespace platon
