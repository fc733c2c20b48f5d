#include "client/lobby/own_addresses.h"

#include <gtest/gtest.h>

#include "protocol/transport/socket_address.h"

namespace platon {
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

}  // namespace
}  // namespace platon
