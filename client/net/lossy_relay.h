#pragma once

#include <netinet/in.h>

#include <cstdint>
#include <optional>

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

}  // namespace platon
