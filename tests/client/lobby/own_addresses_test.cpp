#include "client/lobby/own_addresses.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "protocol/transport/socket_address.h"

namespace platon::own_addresses_test {
namespace {

TEST(OwnAddresses, AreAddressesOfOtherThanThisMachineAlone) {
  bool ipv4 = true;
  for (const std::string& text : ownAddresses()) {
    const std::optional<IpAddress> address = IpAddress::parse(text);
    ASSERT_TRUE(address) << text;
    EXPECT_FALSE(address->isLoopback()) << text;
    EXPECT_TRUE(ipv4 || !address->isIpv4()) << "IPv4 first: " << text;
    ipv4 = address->isIpv4();
  }
}

TEST(BroadcastAddresses, AreNoAddressesOfThisMachine) {
  const std::vector<std::string> own = ownAddresses();
  for (const IpAddress& address : broadcastAddresses()) {
    EXPECT_TRUE(address.isIpv4()) << address.text();
    EXPECT_FALSE(address.isLoopback()) << address.text();
    EXPECT_EQ(std::count(own.begin(), own.end(), address.text()), 0) << address.text();
  }
}

}  // namespace
}  // namespace platon::own_addresses_test
