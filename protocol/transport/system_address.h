#pragma once

#include <netinet/in.h>
#include <sys/socket.h>

#include "protocol/transport/socket_address.h"

namespace platon {

/// An address as the functions of the system take it; `any.sa_family` tells the kind.
union SystemAddress {
  sockaddr any;
  sockaddr_in ipv4;
  sockaddr_in6 ipv6;
};

/// The address of an AF_INET or AF_INET6 one.
SocketAddress fromSystem(const SystemAddress& system);

/// Fills `system` for a socket of the family AF_INET6 (`ipv6`) or AF_INET, and returns its size. An IPv6 socket also
/// takes IPv4 addresses, an IPv4 socket only these.
socklen_t toSystem(const SocketAddress& address, bool ipv6, SystemAddress& system);

}  // namespace platon
