#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <sodium.h>

#include "protocol/time.h"
#include "protocol/token_bucket.h"
#include "protocol/transport/datagram_socket.h"
#include "protocol/transport/handshake.h"
#include "protocol/transport/noise.h"
#include "protocol/transport/server_identity.h"
#include "protocol/transport/server_sessions.h"
#include "protocol/transport/socket_address.h"

namespace platon {

/// Makes and checks cookies without keeping any: a cookie is a keyed hash of the epoch, the client's address and its
/// ephemeral key. It is valid in its epoch and in the next one: 60 to 120 s.
class CookieJar {
 public:
  /// Length of an epoch.
  static constexpr std::chrono::seconds kEpoch{60};

  /// `secret`: random, known to this server only.
  explicit CookieJar(const CryptoKey& secret) : secret_(secret) {}

  Cookie make(const SocketAddress& client, const CryptoKey& clientKey, Time now) const;
  bool isValid(const Cookie& cookie, const SocketAddress& client, const CryptoKey& clientKey, Time now) const;

 private:
  Cookie makeFor(std::uint64_t epoch, const SocketAddress& client, const CryptoKey& clientKey) const;

  CryptoKey secret_;
};

/// The ephemeral keys of an epoch and of the one before, so that a recorded handshake cannot be repeated while its
/// cookie is valid. The epochs are those of CookieJar. The caller limits how many keys are added in a second.
class RecentKeys {
 public:
  explicit RecentKeys(Time epoch) : epoch_(epoch) {}

  bool contains(const CryptoKey& key, Time now) {
    forget(now);
    return present_.contains(printOf(key)) || former_.contains(printOf(key));
  }

  void add(const CryptoKey& key, Time now) {
    forget(now);
    present_.insert(printOf(key));
  }

 private:
  // The keys are random, so 8 bytes of one identify it. Clients choose them: in a hash table they could all collide.
  using Prints = std::set<std::uint64_t>;

  static std::uint64_t printOf(const CryptoKey& key) {
    std::uint64_t print;
    std::memcpy(&print, key.data(), sizeof print);
    return print;
  }

  void forget(Time now) {
    const std::int64_t number = now / epoch_;
    if (number == number_) return;
    former_ = number == number_ + 1 ? std::move(present_) : Prints();
    present_.clear();
    number_ = number;
  }

  Time epoch_;
  std::int64_t number_ = 0;  // of the present epoch
  Prints present_;
  Prints former_;
};

/// A budget for each of any number of networks, in little memory. Each draws on two of kBuckets buckets, by a keyed
/// hash: a newcomer may share one with an attacker, but hardly both, and nobody can tell with whom.
class NetworkBudgets {
 public:
  static constexpr std::size_t kBuckets = 1024;

  /// Every budget starts full. Who does not know the key cannot tell which networks share a bucket.
  NetworkBudgets(double perSecond, double limit, const CryptoKey& key, Time now)
      : buckets_(kBuckets, TokenBucket(perSecond, limit, now)), key_(key) {}

  /// Takes 1 from both buckets of the network. False if neither holds it.
  bool take(std::uint64_t network, Time now) {
    const auto [first, second] = bucketsOf(network);
    const bool isWithin = first->take(1, now);
    return (second != first && second->take(1, now)) || isWithin;
  }

  /// Whether `take` would succeed.
  bool holds(std::uint64_t network, Time now) {
    const auto [first, second] = bucketsOf(network);
    return TokenBucket(*first).take(1, now) || TokenBucket(*second).take(1, now);
  }

 private:
  std::pair<TokenBucket*, TokenBucket*> bucketsOf(std::uint64_t network) {
    const std::uint64_t hash = hashOf(network);
    return {&buckets_[hash % kBuckets], &buckets_[(hash >> 32) % kBuckets]};
  }
  std::uint64_t hashOf(std::uint64_t network) const {
    static_assert(sizeof key_ >= crypto_shorthash_KEYBYTES && crypto_shorthash_BYTES == sizeof network);
    std::array<std::uint8_t, sizeof network> bytes;
    std::memcpy(bytes.data(), &network, sizeof network);
    std::array<std::uint8_t, sizeof network> hashed;
    crypto_shorthash(hashed.data(), bytes.data(), bytes.size(), key_.data());
    std::uint64_t hash = 0;
    std::memcpy(&hash, hashed.data(), sizeof hash);
    return hash;
  }

  std::vector<TokenBucket> buckets_;
  CryptoKey key_;
};

/// Answers the datagrams of those who have no session: queries and handshakes, which begin sessions. A handshake costs
/// the server nothing until the client has proved that it receives at its address: no memory, and no answer longer than
/// the request. Then it costs a key exchange, for which each network has a budget.
class ServerAdmission {
 public:
  /// The references must outlive this.
  ServerAdmission(const ServerIdentity& identity, const GateSettings& settings, const GateRules& rules,
                  CountedSocket& socket, ServerSessions& sessions, Rejections& rejections, Time now);

  /// Handles a datagram that is not sealed.
  void receive(const Datagram& datagram, Time now);
  /// What queries are told. `version`, `nonce`, `identity` and `needsPassword` are filled in.
  void setInfo(Info info) { info_ = std::move(info); }

 private:
  void answerKnock(const Datagram& datagram, Time now);
  void answerQuery(const Datagram& datagram, Time now);
  void answerOpen(const Datagram& datagram, Time now);
  bool mayExchange(const Datagram& datagram, const Open& open, Time now);
  bool takeBudget(const IpAddress& client, Time now);
  std::optional<ServerSessions::Agreement> exchange(const Open& open, std::uint16_t slot) const;
  void refuse(const Datagram& datagram, const CryptoKey& clientKey, RefusalReason reason, const std::string& text,
              Time now);

  ServerIdentity identity_;
  CryptoKey presharedKey_;
  bool needsPassword_;
  const GateRules& rules_;
  CountedSocket& socket_;
  ServerSessions& sessions_;
  Rejections& rejections_;
  Info info_;
  CookieJar cookies_;
  RecentKeys usedKeys_;
  TokenBucket handshakes_;
  TokenBucket queries_;
  NetworkBudgets households_;
  NetworkBudgets sites_;
};

}  // namespace platon
