#include "protocol/transport/system_address.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>

#include <cstring>

namespace platon::system_address_test {
namespace {

const SocketAddress kIpv4{IpAddress::parse("192.0.2.1").value(), 7777};
const SocketAddress kIpv6{IpAddress::parse("2001:db8::1").value(), 7778};

TEST(SystemAddress, AnIpv4SocketTakesTheFourBytes) {
  SystemAddress system;
  EXPECT_EQ(toSystem(kIpv4, false, system), sizeof(sockaddr_in));
  EXPECT_EQ(system.any.sa_family, AF_INET);
  EXPECT_EQ(system.ipv4.sin_port, htons(7777));
  EXPECT_EQ(system.ipv4.sin_addr.s_addr, inet_addr("192.0.2.1"));
  EXPECT_EQ(fromSystem(system), kIpv4);
}

TEST(SystemAddress, AnIpv6SocketTakesBothKinds) {
  for (const SocketAddress& address : {kIpv4, kIpv6}) {
    SystemAddress system;
    EXPECT_EQ(toSystem(address, true, system), sizeof(sockaddr_in6));
    EXPECT_EQ(system.any.sa_family, AF_INET6);
    EXPECT_EQ(system.ipv6.sin6_port, htons(address.port));
    EXPECT_EQ(std::memcmp(&system.ipv6.sin6_addr, address.ip.bytes.data(), 16), 0);
    EXPECT_EQ(system.ipv6.sin6_scope_id, 0u);
    EXPECT_EQ(fromSystem(system), address);
  }
}

}  // namespace
}  // namespace platon::system_address_test
