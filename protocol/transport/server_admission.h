#pragma once

#include <optional>
#include <string>

#include "protocol/token_bucket.h"
#include "protocol/transport/cookie_jar.h"
#include "protocol/transport/datagram_socket.h"
#include "protocol/transport/handshake.h"
#include "protocol/transport/network_budgets.h"
#include "protocol/transport/recent_keys.h"
#include "protocol/transport/rejections.h"
#include "protocol/transport/server_identity.h"
#include "protocol/transport/server_sessions.h"

namespace platon {

/// Answers the datagrams of those who have no session: queries and handshakes, which begin sessions. A handshake costs
/// the server nothing until the client has proved that it receives at its address: no memory, and no answer longer than
/// the request. Then it costs a key exchange, for which each network has a budget.
class ServerAdmission {
 public:
  /// The references must outlive this.
  ServerAdmission(const ServerIdentity& identity, const GateSettings& settings, const GateRules& rules,
                  CountedSocket& socket, ServerSessions& sessions, Rejections& rejections, Moment now);

  /// Handles a datagram that is not sealed.
  void receive(const Datagram& datagram, Moment now);
  /// What queries are told. `version`, `nonce`, `identity` and `needsPassword` are filled in.
  void setInfo(Info info) { info_ = std::move(info); }

 private:
  void answerKnock(const Datagram& datagram, Moment now);
  void answerQuery(const Datagram& datagram, Moment now);
  void answerOpen(const Datagram& datagram, Moment now);
  bool mayExchange(const Datagram& datagram, const Open& open, Moment now);
  bool takeBudget(const IpAddress& client, Moment now);
  std::optional<ServerSessions::Agreement> exchange(const Open& open, std::uint16_t slot) const;
  void refuse(const Datagram& datagram, const CryptoKey& clientKey, RefusalReason reason, const std::string& text,
              Moment now);

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
