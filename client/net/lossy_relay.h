#pragma once

#include <netinet/in.h>

#include <cstdint>
#include <optional>

#include "client/net/lossy_relay.h"
#include "client/net/network_conditions.h"
#include "protocol/transport/server_address.h"

namespace platon {

/// Forwards UDP datagrams between one local client and a server under simulated network conditions, both ways. The
/// conditions affect every datagram: handshakes, acknowledgements and retransmissions too. A client that reconnects
/// from another port gets another port towards the server, as behind a NAT router.
class LossyRelay {
 public:
  /// Opens two sockets. Throws std::runtime_error if the host name cannot be resolved or no socket is available.
  /// `eachWay`: the conditions in each direction; the random numbers of both are derived from `seed`.
  LossyRelay(const ServerAddress& server, const LinkQuality& eachWay, std::uint64_t seed);

  /// The address to which the client has to connect.
  ServerAddress address() const { return {"127.0.0.1", port_}; }

  /// Applies to datagrams received from now on.
  void setQuality(const LinkQuality& eachWay);
  /// Receives datagrams and forwards those that are due at `now`. Call every few milliseconds.
  void pump(Moment now);

 private:
  struct Socket {
    Socket();
    ~Socket();
    Socket(const Socket&) = delete;
    Socket& operator=(const Socket&) = delete;
    int handle;
  };

  bool connectToServer() const;
  void setClient(const sockaddr_in& client);
  void receiveFromClient(Moment now);
  void receiveFromServer(Moment now);

  sockaddr_in server_;
  Socket clientSide_;
  std::optional<Socket> serverSide_;
  std::uint16_t port_ = 0;
  sockaddr_in client_{};  // port 0 until the client has sent a datagram
  NetworkConditions up_;
  NetworkConditions down_;
};

/// A bot's route to the server: direct, or through a relay of its own that simulates network conditions.
class ServerRoute {
 public:
  /// Uses a relay unless `quality` is perfect. `seed`: of the relay's random numbers. Throws std::runtime_error as
  /// LossyRelay does.
  ServerRoute(const ServerAddress& server, const LinkQuality& quality, std::uint64_t seed) : server_(server) {
    if (!quality.perfect()) relay_.emplace(server, quality, seed);
  }

  /// The address to connect to.
  ServerAddress address() const { return relay_ ? relay_->address() : server_; }
  /// Forwards datagrams. Call before the bot receives and after it has sent.
  void pump(Moment now) {
    if (relay_) relay_->pump(now);
  }

 private:
  ServerAddress server_;
  std::optional<LossyRelay> relay_;
};

}  // namespace platon
