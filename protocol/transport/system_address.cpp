#include "protocol/transport/system_address.h"

#include <cstring>

namespace platon {

SocketAddress fromSystem(const SystemAddress& system) {
  SocketAddress address;
  if (system.any.sa_family == AF_INET6) {
    std::memcpy(address.ip.bytes.data(), &system.ipv6.sin6_addr, address.ip.bytes.size());
    address.port = ntohs(system.ipv6.sin6_port);
    return address;
  }
  std::array<std::uint8_t, sizeof(in_addr)> bytes{};
  std::memcpy(bytes.data(), &system.ipv4.sin_addr, bytes.size());
  return {IpAddress::ofIpv4(bytes), ntohs(system.ipv4.sin_port)};
}

socklen_t toSystem(const SocketAddress& address, bool ipv6, SystemAddress& system) {
  std::memset(&system, 0, sizeof system);
  if (ipv6) {
    system.ipv6.sin6_family = AF_INET6;
    system.ipv6.sin6_port = htons(address.port);
    std::memcpy(&system.ipv6.sin6_addr, address.ip.bytes.data(), address.ip.bytes.size());
    return sizeof system.ipv6;
  }
  system.ipv4.sin_family = AF_INET;
  system.ipv4.sin_port = htons(address.port);
  const auto bytes = address.ip.ipv4();
  std::memcpy(&system.ipv4.sin_addr, bytes.data(), bytes.size());
  return sizeof system.ipv4;
}

}  // namespace platon
