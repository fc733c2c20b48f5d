#include "server/admin/origin_address.h"

#include <gtest/gtest.h>

#include "tests/support/origins.h"

namespace platon {
namespace {

TEST(OriginAddress, IsTheIpv4AddressOrTheFirstOfIts64Bits) {
  EXPECT_EQ(addressOfOrigin(originOf("192.0.2.7")), IpAddress::parse("192.0.2.7"));
  EXPECT_EQ(addressOfOrigin(originOf("2001:db8::1:7")), IpAddress::parse("2001:db8::"));
}

TEST(OriginAddress, ThisMachineHasNone) { EXPECT_EQ(addressOfOrigin(0), std::nullopt); }

}  // namespace
}  // namespace platon
