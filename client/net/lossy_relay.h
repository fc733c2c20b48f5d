#pragma once

#include <netinet/in.h>

#include <cstdint>
#include <optional>

#include "client/net/network_conditions.h"
#include "client/net/server_address.h"

namespace platon {

/// Stands between one client on this machine and a server: forwards whole UDP datagrams both ways under simulated
/// network conditions. All that the client sends and gets is subject to them, handshake, acknowledgements and resent
/// packets included, as on a real bad line. A client that begins anew from another port has another way to the server,
/// too, as through a router.
class LossyRelay {
 public:
  /// Opens two sockets. Throws std::runtime_error when the host is unknown or no socket can be had.
  LossyRelay(const ServerAddress& server, const LinkQuality& eachWay, std::uint64_t seed);

  /// Where the client finds the server now.
  ServerAddress address() const { return {"127.0.0.1", port_}; }

  /// What comes from now on is subject to this.
  void setQuality(const LinkQuality& eachWay);
  /// Takes in what has come and passes on what is due at `now`. To be called every few milliseconds at least.
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
  void takeUp(const sockaddr_in& client);
  void takeFromClient(Moment now);
  void takeFromServer(Moment now);

  sockaddr_in server_;
  Socket clientSide_;
  std::optional<Socket> serverSide_;
  std::uint16_t port_ = 0;
  sockaddr_in client_{};  // port 0 until the client has sent something
  NetworkConditions up_;
  NetworkConditions down_;
};

}  // namespace platon
