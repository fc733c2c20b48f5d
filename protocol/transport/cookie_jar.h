#pragma once

#include "protocol/moment.h"
#include "protocol/transport/handshake.h"
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

  Cookie make(const SocketAddress& client, const CryptoKey& clientKey, Moment now) const;
  bool isValid(const Cookie& cookie, const SocketAddress& client, const CryptoKey& clientKey, Moment now) const;

 private:
  Cookie makeFor(std::uint64_t epoch, const SocketAddress& client, const CryptoKey& clientKey) const;

  CryptoKey secret_;
};

}  // namespace platon
