#include "client/lobby/near_servers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <string>

#include "protocol/limits.h"
#include "protocol/transport/socket_address.h"
#include "tests/net/support/datagram_network.h"

namespace platon::near_servers_test {
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

using namespace std::chrono_literals;

constexpr Time kNow = 100s;

class NearServersTest : public testing::Test {
 protected:
  // The query that the search has sent last.
  Query lastQuery() const { return decodeQuery(network_.sent().back().bytes).value(); }

  void answer(std::uint8_t identity, const SocketAddress& from, std::uint16_t players = 1, std::uint64_t other = 0) {
    Info info;
    info.version = kProtocolVersion;
    info.nonce = lastQuery().nonce + other;
    info.identity[0] = identity;
    info.players = players;
    info.maxPlayers = 8;
    info.name = name_;
    network_.inject(from, own_, encode(info));
  }

  const SocketAddress own_ = addressAt("192.0.2.1", 5000);
  const SocketAddress all_ = addressAt("192.0.2.255", 7777);
  const SocketAddress one_ = addressAt("192.0.2.2", 7777);
  std::string name_ = "Den";
  DatagramNetwork network_;
  NearServers servers_{network_.socket(own_), {all_, addressAt("127.0.0.1", 7777)}, 42};
};

TEST_F(NearServersTest, AsksAllTargetsEveryTwoSecondsWithAnotherNonce) {
  servers_.update(kNow);
  ASSERT_EQ(network_.sent().size(), 2U);
  EXPECT_EQ(network_.sent()[0].to, all_);
  const std::uint64_t first = lastQuery().nonce;
  servers_.update(kNow + 1999ms);
  EXPECT_EQ(network_.sent().size(), 2U);
  servers_.update(kNow + 2s);
  EXPECT_EQ(network_.sent().size(), 4U);
  EXPECT_NE(lastQuery().nonce, first);
}

TEST_F(NearServersTest, ListsWhoAnswersWithTheTimeThatItTook) {
  servers_.update(kNow);
  answer(1, one_);
  servers_.update(kNow + 3ms);
  ASSERT_EQ(servers_.list().size(), 1U);
  EXPECT_EQ(servers_.list()[0].address, one_);
  EXPECT_EQ(describe(servers_.list()[0]), "1/8 players, 3 ms");
  EXPECT_EQ(textOf(servers_.list()), "192.0.2.2:7777          1/8 players, 3 ms               Den\n");
}

// Such a name was a blank.
TEST_F(NearServersTest, OfANameIsShownWhatCanBeSeen) {
  servers_.update(kNow);
  name_ = " D\u200ben \u202f";
  answer(1, one_);
  name_ = "\u200b";
  answer(2, one_);
  servers_.update(kNow + 3ms);
  ASSERT_EQ(servers_.list().size(), 2U);
  EXPECT_EQ(servers_.list()[0].info.name, "Den");
  EXPECT_EQ(servers_.list()[1].info.name, "");
}

TEST_F(NearServersTest, OneServerIsListedOnceHoweverManyOfItsAddressesAnswer) {
  servers_.update(kNow);
  answer(1, one_);
  answer(1, addressAt("127.0.0.1", 7777));
  answer(1, addressAt("192.0.2.2", 7778));
  answer(2, one_);
  servers_.update(kNow + 3ms);
  ASSERT_EQ(servers_.list().size(), 3U) << "another port or identity is another server";
  EXPECT_EQ(servers_.list()[0].address, one_);
  EXPECT_EQ(servers_.list()[1].address, addressAt("192.0.2.2", 7778));
  EXPECT_EQ(servers_.list()[2].address, one_);
}

TEST_F(NearServersTest, AnswersToNoQuestionAreIgnored) {
  servers_.update(kNow);
  answer(1, one_, 1, 1);
  network_.inject(one_, own_, Bytes(5));
  network_.inject(one_, own_, encode(lastQuery()));
  servers_.update(kNow + 3ms);
  EXPECT_TRUE(servers_.list().empty());
}

TEST_F(NearServersTest, TellsWhatIsNewAndWhoIsSilent) {
  servers_.update(kNow);
  answer(1, one_, 1);
  servers_.update(kNow + 2s);
  ASSERT_EQ(servers_.list().size(), 1U);
  answer(1, one_, 5);
  servers_.update(kNow + 2100ms);
  EXPECT_EQ(servers_.list()[0].info.players, 5);
  for (int i = 2; i <= 4; ++i) {
    servers_.update(kNow + i * 2s);
    EXPECT_FALSE(isSilent(servers_.list()[0])) << i;
  }
  servers_.update(kNow + 10s);
  ASSERT_EQ(servers_.list().size(), 1U) << "it keeps its place";
  EXPECT_EQ(describe(servers_.list()[0]), "no answer");
}

// Somebody in the network who sends faster than they are taken kept the menu from being drawn.
TEST_F(NearServersTest, AFloodOfAnswersDoesNotKeepTheCaller) {
  servers_.update(kNow);
  for (int i = 0; i < NearServers::kMaxDatagrams; ++i) network_.inject(one_, own_, Bytes{1});
  answer(1, one_);
  servers_.update(kNow + 1ms);
  EXPECT_TRUE(servers_.list().empty());
  servers_.update(kNow + 2ms);
  EXPECT_EQ(servers_.list().size(), 1U);
}

TEST_F(NearServersTest, AFloodOfAnswersFillsABoundedList) {
  servers_.update(kNow);
  for (int i = 0; i < 200; ++i) answer(static_cast<std::uint8_t>(i), one_);
  servers_.update(kNow + 3ms);
  EXPECT_EQ(servers_.list().size(), NearServers::kMaxServers);
  for (int i = 1; i <= 4; ++i) servers_.update(kNow + i * 2s);
  answer(201, one_);
  servers_.update(kNow + 9s);
  EXPECT_EQ(servers_.list().size(), NearServers::kMaxServers);
  EXPECT_EQ(servers_.list()[0].info.identity[0], 201) << "a silent one gives up its place";
}

TEST_F(NearServersTest, SaysWhatKeepsAPlayerOut) {
  NearServer server;
  server.info.version = kProtocolVersion + 1;
  server.info.needsPassword = true;
  EXPECT_EQ(describe(server), "0/0 players, 0 ms, password, newer version");
  server.info.version = kProtocolVersion - 1;
  EXPECT_EQ(describe(server), "0/0 players, 0 ms, password, older version");
}

}  // namespace
}  // namespace platon::near_servers_test
