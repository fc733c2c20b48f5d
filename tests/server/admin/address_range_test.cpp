#include "server/admin/address_range.h"

#include <gtest/gtest.h>

namespace platon::address_range_test {
namespace {

IpAddress ip(const std::string& text) { return IpAddress::parse(text).value(); }
AddressRange range(const std::string& text) { return std::get<AddressRange>(AddressRange::parse(text)); }

std::string errorOf(std::string_view text) {
  const auto parsed = AddressRange::parse(text);
  const auto* error = std::get_if<ParseError>(&parsed);
  return error ? error->what : "none";
}

TEST(AddressRange, HoldsTheAddressesWithItsFirstBits) {
  EXPECT_TRUE(range("192.0.2.0/24").contains(ip("192.0.2.255")));
  EXPECT_FALSE(range("192.0.2.0/24").contains(ip("192.0.3.0")));
  EXPECT_TRUE(range("192.0.2.128/25").contains(ip("192.0.2.200")));
  EXPECT_FALSE(range("192.0.2.128/25").contains(ip("192.0.2.127")));
  EXPECT_TRUE(range("2001:db8::/33").contains(ip("2001:db8:7fff::1")));
  EXPECT_FALSE(range("2001:db8::/33").contains(ip("2001:db8:8000::1")));
}

TEST(AddressRange, ASingleAddressHoldsOnlyItself) {
  EXPECT_EQ(range("192.0.2.7"), range("192.0.2.7/32"));
  EXPECT_EQ(range("2001:db8::1"), range("2001:db8::1/128"));
  EXPECT_TRUE(range("192.0.2.7").contains(ip("192.0.2.7")));
  EXPECT_FALSE(range("192.0.2.7").contains(ip("192.0.2.6")));
}

TEST(AddressRange, RangesOfOneFamilyHoldNoneOfTheOther) {
  EXPECT_TRUE(range("0.0.0.0/0").contains(ip("255.255.255.255")));
  EXPECT_FALSE(range("0.0.0.0/0").contains(ip("::1")));
  EXPECT_TRUE(range("::/0").contains(ip("ffff::1")));
  EXPECT_FALSE(range("::/0").contains(ip("192.0.2.7")));
}

TEST(AddressRange, AnIpv4AddressInIpv6FormIsAnIpv4Address) {
  EXPECT_EQ(range("::ffff:192.0.2.0/120"), range("192.0.2.0/24"));
  EXPECT_EQ(range("::ffff:192.0.2.7"), range("192.0.2.7"));
}

TEST(AddressRange, TheHouseholdOfAnIpv6AddressIsItsFirst64Bits) {
  EXPECT_EQ(AddressRange::householdOf(ip("192.0.2.7")), range("192.0.2.7"));
  EXPECT_EQ(AddressRange::householdOf(ip("2001:db8:1:2:3:4:5:6")), range("2001:db8:1:2::/64"));
}

TEST(AddressRange, TheHouseholdOfATranslatedAddressIsThisOne) {
  EXPECT_EQ(AddressRange::householdOf(ip("64:ff9b::192.0.2.7")), range("64:ff9b::c000:207"));
}

TEST(AddressRange, ParsingReversesTheText) {
  for (const char* text : {"192.0.2.7", "192.0.2.0/24", "0.0.0.0/0", "10.0.0.0/8", "2001:db8::1", "2001:db8::/32",
                           "::/0", "fe80::/10", "255.255.255.254/31"}) {
    EXPECT_EQ(range(text).text(), text);
  }
}

TEST(AddressRange, EveryRangeAroundAnAddressHoldsItAndHasAText) {
  for (const char* text : {"203.0.113.77", "2001:db8:ffff:1234:5678:9abc:def0:1234"}) {
    const unsigned least = ip(text).isIpv4() ? AddressRange::kIpv4Bits : 0;
    for (unsigned bits = least; bits <= AddressRange::kBits; ++bits) {
      const AddressRange around = AddressRange::around(ip(text), bits);
      EXPECT_TRUE(around.contains(ip(text))) << around.text();
      EXPECT_EQ(range(around.text()), around);
    }
  }
}

TEST(AddressRange, SaysWhatIsWrong) {
  const std::string noAddress = " is not an address or a range of addresses, such as 192.0.2.7 or 2001:db8::/32";
  EXPECT_EQ(errorOf("Ann"), "'Ann'" + noAddress);
  EXPECT_EQ(errorOf(""), "''" + noAddress);
  EXPECT_EQ(errorOf("192.0.2"), "'192.0.2'" + noAddress);
  EXPECT_EQ(errorOf("192.0.2.7.1/8"), "'192.0.2.7.1/8'" + noAddress);
  EXPECT_EQ(errorOf("fe80::1%eth0"), "'fe80::1%eth0'" + noAddress);
  EXPECT_EQ(errorOf(std::string_view("192.0.2.7\0x", 11)), "'192.0.2.7?x'" + noAddress);
  EXPECT_EQ(errorOf("192.0.2.0/33"), "the number after the / of '192.0.2.0/33' must be 0 to 32");
  EXPECT_EQ(errorOf("2001:db8::/129"), "the number after the / of '2001:db8::/129' must be 0 to 128");
  for (const char* text : {"192.0.2.0/", "192.0.2.0/-1", "192.0.2.0/+8", "192.0.2.0/8x", "192.0.2.0/8/8"}) {
    EXPECT_TRUE(errorOf(text).ends_with(" must be 0 to 32")) << text;
  }
  EXPECT_EQ(errorOf("192.0.2.7/24"), "'192.0.2.7/24' has bits after its first 24: write 192.0.2.0/24");
  EXPECT_EQ(errorOf("2001:db8::1/32"), "'2001:db8::1/32' has bits after its first 32: write 2001:db8::/32");
  EXPECT_EQ(errorOf("::ffff:0:0/80"), "'::ffff:0:0/80' has bits after its first 80: write ::/80");
}

}  // namespace
}  // namespace platon::address_range_test
