#include "server/admin/enforce_bans.h"

#include <gtest/gtest.h>

#include "tests/support/test_levels.h"

namespace platon::enforce_bans_test {
namespace {

const UtcTime kNow = *parseUtcTime("2026-11-22T12:00:00Z");

BanList listOf(const std::string& text) { return std::get<BanList>(BanList::parse(text)); }

/// A match with two players of one address, one of another, and one of this machine.
class EnforceBansTest : public testing::Test {
 protected:
  EnforceBansTest() {
    for (const ClientId client : {1u, 2u}) join(client, "192.0.2.7");
    join(3, "192.0.2.8");
    join(4, "127.0.0.1");
    match_.takeOutgoing();
  }

  void join(ClientId client, const char* address) {
    Hello hello;
    hello.token = SessionToken{static_cast<std::uint8_t>(client)};
    match_.receive(client, hello, *IpAddress::parse(address));
  }

  Match match_{LevelRotation({levelOf(farGoalText())}), {8, "Test"}};
};

TEST_F(EnforceBansTest, RemovesEveryPlayerOfABannedAddress) {
  EXPECT_EQ(enforceBans(match_, listOf("192.0.2.7 too loud\n"), kNow), 2u);
  EXPECT_FALSE(match_.isPlaying(1));
  EXPECT_FALSE(match_.isPlaying(2));
  EXPECT_TRUE(match_.isPlaying(3));
  EXPECT_TRUE(match_.isPlaying(4));
  const std::span<const Outgoing> sent = match_.takeOutgoing();
  ASSERT_EQ(sent.size(), 2u);
  for (const Outgoing& message : sent) {
    EXPECT_TRUE(message.last);
    EXPECT_EQ(std::get<Bye>(*decodeToClient(message.bytes)).reason, "you are banned from this server: too loud");
  }
}

TEST_F(EnforceBansTest, RemovesDisconnectedPlayersToo) {
  match_.disconnect(1);
  EXPECT_EQ(enforceBans(match_, listOf("192.0.2.0/24\n"), kNow), 3u);
  EXPECT_EQ(match_.playerStatus().size(), 1u);
}

TEST_F(EnforceBansTest, ABanOfOneIpv6AddressHitsThisAddressOnly) {
  join(5, "2001:db8::1");
  join(6, "2001:db8::2");  // of the same household
  EXPECT_EQ(enforceBans(match_, listOf("2001:db8::1\n"), kNow), 1u);
  EXPECT_FALSE(match_.isPlaying(5));
  EXPECT_TRUE(match_.isPlaying(6));
}

TEST_F(EnforceBansTest, APlayerThatHasMovedIsBannedByItsPresentAddress) {
  EXPECT_TRUE(match_.move(3, *IpAddress::parse("198.51.100.9")));
  EXPECT_EQ(enforceBans(match_, listOf("192.0.2.8\n"), kNow), 0u);
  match_.disconnect(3);
  EXPECT_EQ(enforceBans(match_, listOf("198.51.100.9\n"), kNow), 1u);
}

TEST_F(EnforceBansTest, NobodyLeavesWithoutABanThatHolds) {
  EXPECT_EQ(enforceBans(match_, BanList(), kNow), 0u);
  EXPECT_EQ(enforceBans(match_, listOf("192.0.2.7 until 2026-11-22T12:00:00Z\n"), kNow), 0u);
  EXPECT_EQ(match_.players(), 4u);
}

// Nobody can lock out the person who sits at the machine.
TEST_F(EnforceBansTest, ThePlayersOfThisMachineStay) {
  join(5, "::1");
  EXPECT_EQ(enforceBans(match_, listOf("0.0.0.0/0\n::/0\n"), kNow), 3u);
  EXPECT_TRUE(match_.isPlaying(5));
  EXPECT_TRUE(match_.isPlaying(4));
}

}  // namespace
}  // namespace platon::enforce_bans_test
