#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "protocol/transport/client_gate.h"
#include "protocol/transport/server_gate.h"
#include "tests/fuzz/fixed_random.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/net/support/datagram_network.h"

namespace platon::fuzz {

/// A server and newcomers, in memory and in virtual time. An attacker has the network: nothing is delivered unless it
/// does so. After each datagram the laws of docs/protocol.md and docs/security.md are checked.
class HandshakeWorld {
 public:
  static constexpr std::size_t kClients = 3;
  static constexpr std::uint32_t kMaxSessions = 4;
  static constexpr std::size_t kMinContentBytes = 4;
  static constexpr std::size_t kMaxContentBytes = 60;

  struct Setup {
    std::uint32_t sessions = 1;              ///< 1 … kMaxSessions
    std::uint32_t sessionsPerHousehold = 1;  ///< at least 1
    bool needsPassword = false;
    bool clientsKnowIdentity = false;
    bool clientsHavePassword = false;  ///< then the server asks for none: Argon2id is too slow here
  };

  explicit HandshakeWorld(const Setup& setup);

  /// Addresses of the clients first, then those of others, some of which cannot be answered.
  static const std::vector<SocketAddress>& addresses();
  static const SocketAddress& server();
  /// Public key of the server.
  static const CryptoKey& identity();

  void wait(Time duration) { now_ += duration; }
  void updateClient(std::size_t client) { clients_[client].gate->update(now_); }
  /// Begins again with another key.
  void restartClient(std::size_t client);
  /// Contents of kMinContentBytes … kMaxContentBytes.
  void sendFromClient(std::size_t client, std::size_t bytes);
  /// To the n-th session.
  void sendFromServer(std::size_t session, std::size_t bytes);
  void confirm(std::size_t session);
  void close(std::size_t session);
  void expire();
  void setBanned(bool banned) { banned_ = banned; }

  /// Delivers a datagram, in any name.
  void deliverToServer(const SocketAddress& from, ByteSpan datagram);
  void deliverToClient(std::size_t client, const SocketAddress& from, ByteSpan datagram);
  /// An Open for a cookie that was issued to this address; with a wrong key exchange unless `isRight`. Empty if there
  /// is no such cookie.
  platon::Bytes openFor(const SocketAddress& client, bool isRight);
  /// A Knock with a key for `openFor`.
  platon::Bytes knock();

  /// All that was sent.
  const std::vector<DatagramNetwork::Sent>& sent() const { return network_.sent(); }
  /// After all that has happened, a newcomer can join and play.
  void checkNewcomer();
  /// The first law that was broken; empty: none.
  const std::string& fault() const { return fault_; }

 private:
  static constexpr CryptoKey kSecret{9};

  struct Client {
    KeyPair keys;
    std::unique_ptr<ClientGate> gate;
  };
  struct Issued {
    SocketAddress client;
    CryptoKey key{};
    Cookie cookie{};
    std::int64_t epoch = 0;
  };
  struct ModelSession {
    SessionId id;
    CryptoKey clientKey{};
    SocketAddress address;
    bool confirmed = false;
    bool closed = false;
    Time shownAt{};                   // when it began, or moved
    std::optional<Time> strayedAt{};  // when a content first came from another address
  };
  struct Content {
    CryptoKey clientKey{};
    platon::Bytes bytes;

    friend auto operator<=>(const Content&, const Content&) = default;  // NOLINT(modernize-use-nullptr)
  };

  void require(bool holds, const char* law);
  void startClient(Client& client, const SocketAddress& own);
  void noteRequest(ByteSpan datagram);
  bool mayOpen(const SocketAddress& from, const Open& open) const;
  void checkAnswers(const SocketAddress& from, ByteSpan datagram, std::size_t before);
  void noteAnswer(const SocketAddress& from, ByteSpan datagram, ByteSpan answer);
  void noteAccept(const SocketAddress& from, ByteSpan datagram, const Accept& accept);
  void checkSessions(const SocketAddress& from, std::size_t before);
  bool isWithinHousehold(const IpAddress& address) const;
  void checkReceived(const ServerGate::Received& received, const SocketAddress& from);
  bool isAddressOfSession(const SocketAddress& address) const;
  void checkTransition(const Client& client, ClientGate::State before, ByteSpan datagram);
  bool wasAccepted(ByteSpan datagram) const;
  platon::Bytes nextContent(std::size_t bytes);
  std::int64_t epoch() const { return now_ / CookieJar::kEpoch; }

  FixedRandom random_;
  Setup setup_;
  Time now_ = std::chrono::hours(1);
  DatagramNetwork network_;
  ServerIdentity identity_{kSecret};
  CryptoKey presharedKey_{};
  bool banned_ = false;
  std::optional<ServerGate> gate_;
  std::vector<Client> clients_;
  KeyPair ownKeys_;
  std::vector<Issued> issued_;
  std::set<CryptoKey> usedKeys_;
  std::set<std::array<std::uint8_t, NoiseExchange::kOverhead>> rightExchanges_;
  std::vector<Accept> accepts_;
  std::vector<ModelSession> sessions_;
  std::set<std::pair<SocketAddress, platon::Bytes>> sealed_;  // by clients
  std::set<Content> toServer_;                                // on the way
  std::set<Content> toClient_;
  std::uint32_t contents_ = 0;
  std::string fault_;
};

}  // namespace platon::fuzz
