#include "protocol/transport/socket_address.h"

#include <arpa/inet.h>

#include <cstring>

#include <gtest/gtest.h>

namespace platon::socket_address_test {
namespace {

IpAddress ip(std::string_view text) { return IpAddress::parse(text).value(); }

TEST(IpAddress, ReadsAndWritesBothKinds) {
  for (const char* text : {"192.0.2.1", "0.0.0.0", "2001:db8::1", "::", "::1"}) EXPECT_EQ(ip(text).text(), text);
  for (const char* text : {"", "here", "1.2.3", "1.2.3.4.5", "[::1]", "::1%lo", "1.2.3.4:5"}) {
    EXPECT_FALSE(IpAddress::parse(text)) << text;
  }
}

TEST(IpAddress, AnIpv4AddressHasOneValue) {
  EXPECT_EQ(ip("192.0.2.1"), ip("::ffff:192.0.2.1"));
  EXPECT_TRUE(ip("::ffff:192.0.2.1").isIpv4());
  EXPECT_FALSE(ip("2001:db8::1").isIpv4());
}

TEST(IpAddress, AnIpv4AddressHasFourBytes) {
  const std::array<std::uint8_t, 4> bytes{192, 0, 2, 1};
  EXPECT_EQ(IpAddress::ofIpv4(bytes), ip("192.0.2.1"));
  EXPECT_EQ(ip("192.0.2.1").ipv4(), bytes);
}

TEST(IpAddress, OnlyTheExactLoopbackAddressesAreLoopback) {
  EXPECT_TRUE(ip("127.0.0.1").isLoopback());
  EXPECT_TRUE(ip("::1").isLoopback());
  EXPECT_FALSE(ip("127.0.0.2").isLoopback());
  EXPECT_FALSE(ip("::2").isLoopback());
  EXPECT_FALSE(ip("::").isLoopback());
}

TEST(IpAddress, AllOfTheLoopbackNetworkIsThisMachine) {
  for (const char* text : {"127.0.0.1", "127.0.0.0", "127.1.2.3", "127.255.255.255", "::ffff:127.1.2.3", "::1"})
    EXPECT_TRUE(ip(text).isThisMachine()) << text;
  for (const char* text : {"126.255.255.255", "128.0.0.0", "0.0.0.0", "::", "::2", "::7f00:1", "7f00::1"})
    EXPECT_FALSE(ip(text).isThisMachine()) << text;
}

TEST(IpAddress, AHouseholdIsAnIpv4AddressOr64BitsOfIpv6) {
  EXPECT_EQ(ip("127.0.0.1").household(), 0u);
  EXPECT_EQ(ip("::1").household(), 0u);
  EXPECT_EQ(ip("192.0.2.1").household(), 0x0000'ffff'c000'0201u);
  EXPECT_EQ(ip("2001:db8::1").household(), 0x2001'0db8'0000'0000u);
  EXPECT_EQ(ip("2001:db8::1").household(), ip("2001:db8::ffff:1:2:3").household());
  EXPECT_NE(ip("2001:db8::1").household(), ip("2001:db8:0:1::1").household());
}

TEST(IpAddress, ASiteIsAnIpv4AddressOr48BitsOfIpv6) {
  EXPECT_EQ(ip("::1").site(), 0u);
  EXPECT_EQ(ip("192.0.2.1").site(), ip("192.0.2.1").household());
  EXPECT_EQ(ip("2001:db8:1:2::1").site(), 0x2001'0db8'0001'0000u);
  EXPECT_NE(ip("2001:db8:1::1").site(), ip("2001:db8:2::1").site());
}

// They counted as loopback, which has no limit.
TEST(IpAddress, AddressesThatBeginWithZerosAreAHouseholdThatIsNotLoopback) {
  for (const char* text : {"::", "::2", "::192.0.2.1", "::1:ffff:ffff:ffff"}) {
    EXPECT_EQ(ip(text).household(), 0x0000'fffe'0000'0000u) << text;
    EXPECT_EQ(ip(text).site(), 0x0000'fffe'0000'0000u) << text;
  }
  EXPECT_EQ(ip("0:0:0:1::1").household(), 1u);
  EXPECT_EQ(ip("0:0:0:1::1").site(), ip("::2").site());
  EXPECT_NE(ip("0:0:1::1").site(), ip("::2").site());
}

// All IPv4 players of a server behind a translator were one household.
TEST(IpAddress, AnAddressThatATranslatorMakesOfAnIpv4AddressCountsAsThisOne) {
  EXPECT_TRUE(ip("64:ff9b::192.0.2.1").holdsIpv4());
  EXPECT_FALSE(ip("64:ff9b::192.0.2.1").isIpv4());
  EXPECT_EQ(ip("64:ff9b::192.0.2.1").household(), ip("192.0.2.1").household());
  EXPECT_EQ(ip("64:ff9b::192.0.2.1").site(), ip("192.0.2.1").site());
  EXPECT_EQ(ip("64:ff9b::127.0.0.1").household(), 0x0000'ffff'7f00'0001u) << "not of this machine: it has limits";
  EXPECT_EQ(ip("64:ff9b::127.0.0.1").site(), 0x0000'ffff'7f00'0001u);
  for (const char* other : {"64:ff9b:0:0:0:1::1", "64:ff9b:1::192.0.2.1", "64:ff9c::192.0.2.1", "::192.0.2.1"}) {
    EXPECT_FALSE(ip(other).holdsIpv4()) << other;
    EXPECT_NE(ip(other).household(), ip("192.0.2.1").household()) << other;
  }
}

TEST(IpAddress, TheInternetDoesNotLeadToAPrivateAddress) {
  for (const char* text : {"0.0.0.0",          "0.1.2.3",         "10.0.0.0",   "10.255.255.255",
                           "127.0.0.1",        "127.255.255.255", "100.64.0.0", "100.127.255.255",
                           "169.254.0.0",      "169.254.255.255", "172.16.0.0", "172.31.255.255",
                           "192.168.0.0",      "192.168.255.255", "::",         "::1",
                           "fc00::",           "fdff:ffff::1",    "fe80::1",    "febf::1",
                           "64:ff9b::10.1.2.3"})
    EXPECT_TRUE(ip(text).isPrivate()) << text;
  for (const char* text : {"1.0.0.0",     "9.255.255.255",
                           "11.0.0.0",    "126.255.255.255",
                           "128.0.0.0",   "100.63.255.255",
                           "100.128.0.0", "169.253.255.255",
                           "169.255.0.0", "172.15.255.255",
                           "172.32.0.0",  "192.167.255.255",
                           "192.169.0.0", "::2",
                           "fbff::1",     "fe00::1",
                           "fe7f::1",     "fec0::1",
                           "2001:db8::1", "64:ff9b::192.0.2.1",
                           "a00::1"})
    EXPECT_FALSE(ip(text).isPrivate()) << text;
}

TEST(SocketAddress, ItsTextHasBracketsAroundIpv6) {
  EXPECT_EQ((SocketAddress{ip("192.0.2.1"), 7777}.text()), "192.0.2.1:7777");
  EXPECT_EQ((SocketAddress{ip("2001:db8::1"), 7777}.text()), "[2001:db8::1]:7777");
}

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
}  // namespace platon::socket_address_test
