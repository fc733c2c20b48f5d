#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/transport/datagram_socket.h"
#include "protocol/transport/sealed_channel.h"

namespace platon {

/// How often something was rejected for one reason.
struct Rejection {
  std::string_view reason;  ///< one word, for logs and metrics
  std::uint64_t count = 0;

  friend bool operator==(const Rejection&, const Rejection&) = default;
};

/// All that a server has rejected so far, by reason. Each part of it that rejects something counts it here.
struct Rejections {
  std::uint64_t malformed = 0;    ///< datagrams of no known form
  std::uint64_t version = 0;      ///< knocks of another protocol version, which were told so
  std::uint64_t cookie = 0;       ///< Open with an invalid cookie, or one that was used before
  std::uint64_t handshakes = 0;   ///< Open beyond the budget of its address or of the server
  std::uint64_t password = 0;     ///< Open with a wrong password
  std::uint64_t full = 0;         ///< Open when no session was free; Open from, or answers to a challenge at, an
                                  ///< address whose household or site has no room
  std::uint64_t banned = 0;       ///< Open from, or answers to a challenge at, a banned address; clients whose address
                                  ///< was banned after they had connected
  std::uint64_t queries = 0;      ///< beyond the budget
  std::uint64_t seal = 0;         ///< sealed datagrams that are forged, damaged, repeated, or of no session
  std::uint64_t unconfirmed = 0;  ///< sessions that were not confirmed in time
  std::uint64_t content = 0;      ///< sealed datagrams with something that no client of ours sends
  std::uint64_t excess = 0;       ///< datagrams beyond the budget of their connection
  std::uint64_t idle = 0;         ///< connections that were not admitted in time
  std::uint64_t silent = 0;       ///< admitted connections from which nothing came
  std::uint64_t slow = 0;         ///< connections that did not acknowledge what was sent
  std::uint64_t message = 0;      ///< messages that were malformed

  /// One for each of these, always in this order.
  std::vector<Rejection> list() const {
    return {{"malformed", malformed}, {"version", version},
            {"cookie", cookie},       {"handshakes", handshakes},
            {"password", password},   {"full", full},
            {"banned", banned},       {"queries", queries},
            {"seal", seal},           {"unconfirmed", unconfirmed},
            {"content", content},     {"excess", excess},
            {"idle", idle},           {"silent", silent},
            {"slow", slow},           {"message", message}};
  }

  friend bool operator==(const Rejections&, const Rejections&) = default;
};

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

/// What the program around a gate decides about addresses. A function that is empty refuses nobody.
struct GateRules {
  /// Tells why an address may not join: a label for the player; nothing if it may. It must have no effect: the address
  /// may be forged.
  std::function<std::optional<std::string>(const IpAddress&)> ban{};
  /// Called for each newcomer that is refused as banned. It has shown that it receives at this address.
  std::function<void(const IpAddress&)> banned{};
  /// Decides whether a session may move to another address, at which it has shown that it receives. If so, it is there
  /// from then on.
  std::function<bool(SessionId, const IpAddress&)> mayMove{};
};

/// The sessions that a gate lets through. Opens and seals what they contain, limits how many there are at one place,
/// and follows a client to another address once it has shown that it receives there.
class ServerSessions {
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

  struct Received {
    SessionId session;
    Bytes bytes;  ///< not empty
  };
  /// What a handshake has agreed on.
  struct Agreement {
    CryptoKey clientKey{};  ///< ephemeral
    SessionKeys keys;
    Bytes accept;  ///< the answer to the client, which is repeated if it was lost
  };

  /// The references must outlive this.
  ServerSessions(const GateSettings& settings, const GateRules& rules, CountedSocket& socket, Rejections& rejections);

  /// The content of a sealed datagram; nothing if it was for the transport, or rejected.
  std::optional<Received> receive(const Datagram& datagram, Time now);
  /// Seals and queues; no effect if the session has ended, the content is too long, or nobody knows where the client
  /// receives: see kUnconfirmedPathTime and kShownAddressTime.
  void send(SessionId session, ByteSpan content, Time now);

  /// Whether one more session may be at this address.
  bool hasRoomFor(const IpAddress& client) const { return hasRoomFor(client, nullptr); }
  /// A free slot; if there is none, that of the session that has waited longest to be confirmed.
  std::optional<std::uint16_t> freeSlot() const;
  /// Begins a session in a slot from `freeSlot`, and sends its answer.
  void begin(std::uint16_t slot, const SocketAddress& client, const Agreement& agreement, Time now);
  /// Whether a session was begun with this key. Sends the answer again if the client may not have it.
  bool repeatAccept(const SocketAddress& client, const CryptoKey& clientKey, Time now);

  void confirm(SessionId session);
  void expire(Time now);
  void close(SessionId session);
  bool isOpen(SessionId session) const { return find(session) != nullptr; }
  /// Address of an open session; `IpAddress{}` if it has ended.
  IpAddress addressOf(SessionId session) const;

 private:
  struct Path {
    SocketAddress address;
    PathChallenge challenge{};
    Time since{};
  };
  struct Session {
    SessionId id;  // number 0: free
    SocketAddress address;
    Time receivedAt{};                          // when the client has last shown that it receives there
    std::optional<PathChallenge> ownChallenge;  // that it was sent there and has not answered
    Time askedAt{};                             // when it was last sent that
    std::optional<SealedChannel> channel;
    CryptoKey clientKey{};
    Bytes accept;                      // repeated when the client repeats its Open; empty once the client has it
    std::optional<Path> path;          // another address from which the client sends, until it has answered there
    std::optional<Time> challengedAt;  // when it was last sent a challenge at another address
    bool confirmed = false;
    Time since{};
  };

  void takeControl(Session& session, const SocketAddress& sender, ByteSpan content, Time now);
  void checkPath(Session& session, const Datagram& datagram, Time now);
  static Time servedUntil(const Session& session);
  void challenge(Session& session, const SocketAddress& receiver, const PathChallenge& challenge, Time now);
  bool isBanned(const IpAddress& address) const { return rules_.ban && rules_.ban(address); }
  bool hasRoomFor(const IpAddress& client, const Session* moving) const;
  const Session* find(SessionId id) const;

  const GateRules& rules_;
  CountedSocket& socket_;
  Rejections& rejections_;
  std::vector<Session> sessions_;
  std::uint32_t sessionsPerHousehold_;
  std::uint32_t nextNumber_;
};

}  // namespace platon
