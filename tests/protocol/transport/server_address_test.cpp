#include "protocol/transport/server_address.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace platon::server_address_test {
namespace {

TEST(ServerAddress, AHostWithoutAPortGetsTheDefaultPort) {
  const ServerAddress address = parseServerAddress("play.example.org");
  EXPECT_EQ(address.host, "play.example.org");
  EXPECT_EQ(address.port, 7777);
  EXPECT_EQ(address.text(), "play.example.org:7777");
}

TEST(ServerAddress, AHostMayBeFollowedByAPort) {
  const ServerAddress address = parseServerAddress("127.0.0.1:65535");
  EXPECT_EQ(address.host, "127.0.0.1");
  EXPECT_EQ(address.port, 65535);
}

TEST(ServerAddress, AnIpv6AddressWithAPortIsInBrackets) {
  for (const char* text : {"::1", "[::1]"}) EXPECT_EQ(parseServerAddress(text).text(), "[::1]:7777");
  const ServerAddress address = parseServerAddress("[2001:db8::1]:80");
  EXPECT_EQ(address.host, "2001:db8::1");
  EXPECT_EQ(address.port, 80);
  EXPECT_EQ(address.text(), "[2001:db8::1]:80");
}

TEST(ServerAddress, AZoneIsRefusedWithARemedy) {
  for (const std::string text : {"fe80::1%eth0", "[fe80::1%eth0]", "[fe80::1%25eth0]:7777", "fe80::1%"}) {
    try {
      parseServerAddress(text);
      ADD_FAILURE() << text << " was accepted";
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(error.what(), "'" + text +
                                  "' is not a server address: an IPv6 address with a zone ('%') is not supported; use "
                                  "the server's name or another of its addresses");
    }
  }
}

class BadAddress : public testing::TestWithParam<const char*> {};

TEST_P(BadAddress, IsRefusedInOneSentence) {
  try {
    parseServerAddress(GetParam());
    FAIL() << "'" << GetParam() << "' was accepted";
  } catch (const std::invalid_argument& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("'" + std::string(GetParam()) + "'"), std::string::npos) << what;
    EXPECT_EQ(what.find('\n'), std::string::npos);
  }
}

INSTANTIATE_TEST_SUITE_P(All, BadAddress,
                         testing::Values("", ":7777", "host:", "host:0", "host:65536", "host:77x", "host: 7", "host:-1",
                                         "a:b:1", "[::1", "[::1]7777", "[host]:1", "::1:x", "host%eth0", "host:1%",
                                         "ho st", "host/7", "host:99999999999999999999"));

TEST(ServerAddress, OneToGoOnHasAtMost128Bytes) {
  EXPECT_TRUE(isNextServer("[2001:db8::1]:7777"));
  EXPECT_TRUE(isNextServer(std::string(kMaxNextServerBytes, 'x')));
  EXPECT_FALSE(isNextServer(std::string(kMaxNextServerBytes + 1, 'x')));
  for (const char* text : {"", "a b", "host:0", "ho/st", "host:99999"}) EXPECT_FALSE(isNextServer(text)) << text;
}

}  // namespace
}  // namespace platon::server_address_test
