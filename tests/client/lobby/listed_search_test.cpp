#include "client/lobby/listed_servers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "protocol/limits.h"
#include "tests/net/support/datagram_network.h"

namespace platon::listed_search_test {
namespace {

using namespace std::chrono_literals;

constexpr Time kNow = 100s;

class ListedSearchTest : public testing::Test {
 protected:
  static ListedServer listed(std::uint8_t key, const std::string& address) {
    CryptoKey secret{};
    secret.fill(key);
    return listedServer(ServerIdentity(secret), parseServerAddress(address), "Example");
  }

  std::string add(ListedSearch& search, std::uint8_t key, const std::string& ip, std::uint16_t port = 7777) const {
    return search.add(listed(key, ServerAddress{ip, port}.text()), addressAt(ip, port));
  }
  std::string add(std::uint8_t key, const std::string& ip, std::uint16_t port = 7777) {
    return add(search_, key, ip, port);
  }

  // Lets time pass in pictures of 16 ms. Servers answer before each, if `answers`.
  void letPass(Time duration, bool answers = false) {
    const Time end = now_ + duration;
    for (; now_ < end; now_ += 16ms) {
      search_.update(now_);
      for (; answered_ < network_.sent().size(); ++answered_) {
        if (answers) answer(answered_);
      }
    }
  }

  // The server of this key answers the query with this index, from another address of its machine, if there is one.
  void answer(std::size_t query, std::uint8_t key = 1, const std::optional<SocketAddress>& from = std::nullopt) {
    const DatagramNetwork::Sent sent = network_.sent()[query];
    Info info;
    info.version = kProtocolVersion;
    info.nonce = decodeQuery(sent.bytes).value().nonce;
    info.identity = listed(key, "a.example:1").key;
    info.players = 1;
    info.maxPlayers = 8;
    network_.inject(from.value_or(sent.to), own_, encode(info));
  }

  std::map<SocketAddress, std::size_t> queries() const {
    std::map<SocketAddress, std::size_t> queries;
    for (const DatagramNetwork::Sent& sent : network_.sent()) ++queries[sent.to];
    return queries;
  }

  std::vector<std::string> found() const {
    std::vector<std::string> servers;
    for (const FoundServer& server : search_.list())
      servers.push_back(server.listed.address.text() + " " + describe(server.answer));
    return servers;
  }

  const SocketAddress own_ = addressAt("192.0.2.1", 5000);
  DatagramNetwork network_;
  std::uint64_t random_ = 0;
  ListedSearch search_{network_.socket(own_), [this] { return random_ += 1000; }, false};
  Time now_ = kNow;
  std::size_t answered_ = 0;
};

TEST_F(ListedSearchTest, AServerThatAnswersIsAskedAgainEveryTwoSeconds) {
  EXPECT_EQ(add(1, "198.51.100.1"), "");
  EXPECT_TRUE(search_.isBehind());
  letPass(10s, true);
  EXPECT_FALSE(search_.isBehind());
  EXPECT_THAT(found(), testing::ElementsAre("198.51.100.1:7777 1/8 players, 16 ms"));
  EXPECT_EQ(network_.sent().size(), 5u);
  letPass(20s);
  EXPECT_EQ(network_.sent().size(), 15u) << "one that has answered once";
  EXPECT_THAT(found(), testing::ElementsAre("198.51.100.1:7777 no answer"));
}

TEST_F(ListedSearchTest, AServerThatNeverAnswersIsAskedThreeTimes) {
  add(1, "198.51.100.1");
  letPass(60s);
  EXPECT_EQ(network_.sent().size(), ListedSearch::kMaxTries);
}

// A fleet shares a key, and its servers often a port.
TEST_F(ListedSearchTest, ServersThatShareKeyAndPortAreTwo) {
  add(1, "198.51.100.1");
  add(1, "198.51.100.2");
  letPass(1s, true);
  EXPECT_THAT(found(),
              testing::ElementsAre("198.51.100.1:7777 1/8 players, 16 ms", "198.51.100.2:7777 1/8 players, 16 ms"));
}

TEST_F(ListedSearchTest, OnlyTheServerThatWasAskedAnswersUnderItsKey) {
  add(1, "198.51.100.1");
  add(2, "198.51.100.2");
  letPass(16ms);
  ASSERT_EQ(network_.sent().size(), 2u);
  EXPECT_NE(network_.sent()[0].bytes, network_.sent()[1].bytes);
  answer(0, 2);
  answer(1, 1);
  letPass(16ms);
  EXPECT_THAT(found(), testing::IsEmpty()) << "right keys, wrong queries";
  answer(0, 1, addressAt("203.0.113.9", 1));
  letPass(16ms);
  EXPECT_THAT(found(), testing::ElementsAre("198.51.100.1:7777 1/8 players, 32 ms")) << "from any of its addresses";
}

TEST_F(ListedSearchTest, RefusesAddressesThatAreNotOfOneOtherMachine) {
  for (const char* const ip :
       {"0.0.0.0", "0.1.2.3", "224.0.0.1", "239.255.255.250", "255.255.255.255", "::", "ff02::1"})
    EXPECT_EQ(add(1, ip), "its address is not that of a single machine") << ip;
  for (const char* const ip : {"127.0.0.1", "127.1.2.3", "::1"})
    EXPECT_EQ(add(1, ip), "only a list on this machine may name this machine") << ip;
  ListedSearch ofThisMachine(
      network_.socket(own_), [] { return 1; }, true);
  for (const char* const ip : {"127.0.0.1", "127.1.2.3", "::1"}) EXPECT_EQ(add(ofThisMachine, 1, ip), "") << ip;
  EXPECT_NE(add(ofThisMachine, 1, "255.255.255.255"), "");
  letPass(10s);
  EXPECT_EQ(network_.sent().size(), 0u);
}

TEST_F(ListedSearchTest, AskedForOneMachineItAsksAtMost16Servers) {
  EXPECT_EQ(add(1, "198.51.100.1"), "");
  EXPECT_EQ(add(1, "198.51.100.1"), "another entry names this server");
  for (std::uint16_t port = 1; port < ListedSearch::kMaxPerHousehold; ++port)
    EXPECT_EQ(add(1, "198.51.100.1", port), "");
  EXPECT_EQ(add(1, "198.51.100.1", 99), "the list has 16 others at its address or in its IPv6 network");
  for (std::uint16_t i = 1; i <= ListedSearch::kMaxPerHousehold; ++i)
    EXPECT_EQ(add(1, "2001:db8::" + std::to_string(i)), "");
  EXPECT_EQ(add(1, "2001:db8::ffff"), "the list has 16 others at its address or in its IPv6 network")
      << "another address of 64 bits";
  EXPECT_EQ(add(1, "198.51.100.2"), "");
}

TEST_F(ListedSearchTest, AListIsNoFlood) {
  for (std::uint16_t i = 0; i < kMaxListedServers; ++i) {
    add(1, "198.51." + std::to_string(i / 250) + "." + std::to_string(i % 250 + 1));
  }
  letPass(1s);
  EXPECT_NEAR(static_cast<double>(network_.sent().size()), 1000.0 / 3, 20);
  EXPECT_TRUE(search_.isBehind());
  letPass(60s);
  EXPECT_EQ(network_.sent().size(), kMaxListedServers * ListedSearch::kMaxTries);
  for (const auto& [server, asked] : queries()) EXPECT_EQ(asked, ListedSearch::kMaxTries) << server.text();
}

TEST_F(ListedSearchTest, ASilentServerGivesUpItsPlaceToANewOne) {
  for (std::uint16_t i = 0; i <= ListedSearch::kMaxServers; ++i) add(1, "198.51.100." + std::to_string(i + 1));
  letPass(1s);
  for (std::size_t i = 0; i <= ListedSearch::kMaxServers; ++i) answer(i);
  letPass(16ms);
  EXPECT_EQ(search_.list().size(), ListedSearch::kMaxServers);
  letPass(ListedSearch::kInterval * (NearServers::kPatience + 1));
  EXPECT_EQ(found()[0], "198.51.100.1:7777 no answer") << "it keeps its place";
  add(1, "203.0.113.1");
  letPass(32ms);
  answer(network_.sent().size() - 1);
  letPass(16ms);
  EXPECT_EQ(search_.list().size(), ListedSearch::kMaxServers);
  EXPECT_EQ(search_.list().front().listed.address.host, "198.51.100.2");
  EXPECT_EQ(search_.list().back().listed.address.host, "203.0.113.1");
}

TEST_F(ListedSearchTest, OfANameIsShownWhatCanBeSeen) {
  CryptoKey secret{};
  secret.fill(1);
  const ListedServer server =
      listedServer(ServerIdentity(secret), parseServerAddress("198.51.100.1:7777"), "\u200bE\u0301\u0302\u0303  x");
  EXPECT_EQ(search_.add(server, addressAt("198.51.100.1", 7777)), "");
  letPass(100ms, true);
  ASSERT_EQ(search_.list().size(), 1U);
  EXPECT_EQ(search_.list()[0].listed.name, "É\u0302 x");
}

}  // namespace
}  // namespace platon::listed_search_test
