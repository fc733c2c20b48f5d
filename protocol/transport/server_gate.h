#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "protocol/token_bucket.h"
#include "protocol/transport/control.h"
#include "protocol/transport/cookie_jar.h"
#include "protocol/transport/datagram_socket.h"
#include "protocol/transport/network_budgets.h"
#include "protocol/transport/recent_keys.h"
#include "protocol/transport/sealed_channel.h"
#include "protocol/transport/server_identity.h"

namespace platon {

/// A session of the gate. Numbers are used again only after all others; 0 is none.
struct SessionId {
  std::uint32_t number = 0;
  std::uint16_t slot = 0;

  friend bool operator==(const SessionId&, const SessionId&) = default;
};

struct GateSettings {
  std::uint32_t sessions = 24;  ///< most sessions, 1 … 4095
  /// Most sessions of one IpAddress::household, a quarter of those of one IpAddress::site; loopback has no limit.
  std::uint32_t sessionsPerHousehold = 8;
  CryptoKey presharedKey{};  ///< of the password
  bool needsPassword = false;
  std::uint32_t firstNumber = 1;  ///< of the first session; 1 follows the largest
};

/// What the gate has dropped or refused so far, by reason.
struct GateCounters {
  std::uint64_t malformed = 0;    ///< datagrams of no known form
  std::uint64_t version = 0;      ///< knocks of another protocol version, which were told so
  std::uint64_t cookie = 0;       ///< Open with an invalid cookie, or one that was used before
  std::uint64_t handshakes = 0;   ///< Open beyond the budget of its address or of the server
  std::uint64_t password = 0;     ///< Open with a wrong password
  std::uint64_t full = 0;         ///< Open when no session was free; Open from, or answers to a challenge at, an
                                  ///< address whose household or site has no room
  std::uint64_t banned = 0;       ///< Open from, or answers to a challenge at, a banned address
  std::uint64_t queries = 0;      ///< beyond the budget
  std::uint64_t seal = 0;         ///< sealed datagrams that are forged, damaged, repeated, or of no session
  std::uint64_t unconfirmed = 0;  ///< sessions that were not confirmed in time

  friend bool operator==(const GateCounters&, const GateCounters&) = default;
};

/// The server's wall: only datagrams of a session pass. A session begins with a handshake that costs the server
/// nothing until the client has proved that it receives at its address: no memory, and no answer longer than the
/// request. docs/protocol.md specifies it.
class ServerGate {
 public:
  /// Time after the handshake in which a session must be confirmed.
  static constexpr std::chrono::seconds kConfirmTime{3};
  /// While a client sends from another address than the one that it has shown to receive at, content is sent to the
  /// latter for so long after the last sign that it still receives there.
  static constexpr std::chrono::milliseconds kUnconfirmedPathTime{1000};
  /// Content is sent to an address for so long after the client has shown to receive there. In the last
  /// kAskTime of it, the client is asked to show it again: its datagrams alone do not, since a sender can be forged.
  static constexpr std::chrono::seconds kShownAddressTime{15};
  static constexpr std::chrono::seconds kAskTime{5};

  ServerGate(std::unique_ptr<DatagramSocket> socket, const ServerIdentity& identity, const GateSettings& settings,
             Moment now);

  struct Received {
    SessionId session;
    Bytes bytes;  ///< not empty
  };
  /// Datagrams that one round of `receive` takes, so that a flood does not keep the server from its work.
  static constexpr std::size_t kMaxDatagramsPerRound = 2048;

  /// Begins a round of `receive`.
  void beginRound() { left_ = kMaxDatagramsPerRound; }
  /// The next content from a session. Answers all other datagrams on the way; nothing when no datagram waits, or the
  /// round has taken all that it may.
  std::optional<Received> receive(Moment now);
  /// Seals and queues; no effect if the session has ended, the content is too long, or nobody knows where the client
  /// receives: see kUnconfirmedPathTime and kShownAddressTime.
  void send(SessionId session, ByteSpan content, Moment now);
  void flush(Moment now) { socket_->flush(now); }

  /// Call when the session serves a connection: from then on only `close` ends it.
  void confirm(SessionId session);
  /// Ends sessions that were not confirmed in time. Call it regularly.
  void expire(Moment now);
  /// Ends a session. Its datagrams are dropped from now on.
  void close(SessionId session);
  bool isOpen(SessionId session) const { return find(session) != nullptr; }
  /// Address of an open session.
  IpAddress addressOf(SessionId session) const;

  /// Tells why an address may not join: a label for the player; nothing if it may. It must have no effect: the address
  /// may be forged.
  using BanCheck = std::function<std::optional<std::string>(const IpAddress&)>;
  /// Called for each newcomer that is refused by the check. It has shown that it receives at this address.
  using BanNotice = std::function<void(const IpAddress&)>;
  void setBanCheck(BanCheck check, BanNotice notice = {}) {
    banCheck_ = std::move(check);
    banNotice_ = std::move(notice);
  }
  /// Decides whether a session may move to another address, at which it has shown that it receives. If so, it is there
  /// from then on. Without it, a session may move wherever the limits of sessions allow.
  using MoveCheck = std::function<bool(SessionId, const IpAddress&)>;
  void setMoveCheck(MoveCheck check) { moveCheck_ = std::move(check); }
  /// What queries are told. `version`, `nonce`, `identity` and `needsPassword` are filled in.
  void setInfo(Info info) { info_ = std::move(info); }

  DatagramSocket& socket() { return *socket_; }
  const DatagramSocket& socket() const { return *socket_; }
  const GateCounters& counters() const { return counters_; }
  const Traffic& traffic() const { return traffic_; }

 private:
  struct Path {
    SocketAddress address;
    PathChallenge challenge{};
    Moment since{};
  };
  struct Session {
    SessionId id;  // number 0: free
    SocketAddress address;
    Moment receivedAt{};                        // when the client has last shown that it receives there
    std::optional<PathChallenge> ownChallenge;  // that it was sent there and has not answered
    Moment askedAt{};                           // when it was last sent that
    std::optional<SealedChannel> channel;
    CryptoKey clientKey{};
    Bytes accept;                        // repeated when the client repeats its Open; empty once the client has it
    std::optional<Path> path;            // another address from which the client sends, until it has answered there
    std::optional<Moment> challengedAt;  // when it was last sent a challenge at another address
    bool confirmed = false;
    Moment since{};
  };

  std::optional<Received> take(const Datagram& datagram, Moment now);
  std::optional<Received> takeSealed(const Datagram& datagram, Moment now);
  void takeControl(Session& session, const SocketAddress& sender, ByteSpan content, Moment now);
  void checkPath(Session& session, const Datagram& datagram, Moment now);
  static Moment servedUntil(const Session& session);
  void challenge(Session& session, const SocketAddress& receiver, const PathChallenge& challenge, Moment now);
  void takeHandshake(const Datagram& datagram, Moment now);
  void answerKnock(const Datagram& datagram, Moment now);
  void answerOpen(const Datagram& datagram, Moment now);
  void answerQuery(const Datagram& datagram, Moment now);
  bool mayExchange(const Datagram& datagram, const Open& open, Moment now);
  Session* placeForSession();
  bool startSession(Session& session, const SocketAddress& client, const Open& open, Moment now);
  bool repeatAccept(const SocketAddress& client, const CryptoKey& clientKey, Moment now);
  void refuse(const Datagram& datagram, const CryptoKey& clientKey, RefusalReason reason, const std::string& text,
              Moment now);
  void sendPlain(const SocketAddress& receiver, ByteSpan bytes, Moment now);
  bool takeBudget(const IpAddress& client, Moment now);
  bool hasRoomFor(const IpAddress& client, const Session* moving = nullptr) const;
  const Session* find(SessionId id) const;

  std::unique_ptr<DatagramSocket> socket_;
  ServerIdentity identity_;
  GateSettings settings_;
  CookieJar cookies_;
  std::vector<Session> sessions_;
  RecentKeys usedKeys_;
  TokenBucket handshakes_;
  TokenBucket queries_;
  NetworkBudgets households_;
  NetworkBudgets sites_;
  std::uint32_t nextNumber_;
  BanCheck banCheck_;
  BanNotice banNotice_;
  MoveCheck moveCheck_;
  Info info_;
  std::size_t left_ = kMaxDatagramsPerRound;  // datagrams of this round
  GateCounters counters_;
  Traffic traffic_;
};

}  // namespace platon
