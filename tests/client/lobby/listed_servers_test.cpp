#include "client/lobby/listed_servers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <future>
#include <memory>
#include <new>

#include "client/time/steady_now.h"
#include "protocol/transport/udp_socket.h"
#include "server/app/dedicated_server.h"
#include "tests/client/lobby/web_server.h"
#include "tests/net/support/datagram_network.h"
#include "tests/support/test_levels.h"
#include "tests/support/wait_until.h"

namespace platon::listed_servers_test {
namespace {

using Answers = std::vector<std::pair<std::string, std::optional<IpAddress>>>;

const IpAddress kAddress = addressAt("198.51.100.1", 1).ip;

std::optional<IpAddress> onlyKnown(const std::string& host) {
  return host == "known.example" ? std::optional(kAddress) : std::nullopt;
}

Answers take(NameLookup& lookup) {
  Answers answers;
  for (const NameLookup::Answer& answer : lookup.take()) answers.emplace_back(answer.host, answer.address);
  return answers;
}

TEST(NameLookupTest, HandsOverEachAnswerOnce) {
  NameLookup lookup({"a.example", "known.example"}, onlyKnown);
  Answers answers;
  EXPECT_TRUE(waitUntil([&] {
    for (auto& answer : take(lookup)) answers.push_back(std::move(answer));
    return !lookup.isPending();
  }));
  EXPECT_EQ(answers, (Answers{{"a.example", std::nullopt}, {"known.example", kAddress}}));
  EXPECT_EQ(take(lookup), Answers{});
}

TEST(NameLookupTest, ANameWhoseLookupThrowsHasNoAddress) {
  NameLookup lookup({"a.example", "b.example", "known.example"}, [](const std::string& host) {
    if (host == "a.example") throw std::bad_alloc();
    if (host == "b.example") throw 1;
    return onlyKnown(host);
  });
  Answers answers;
  EXPECT_TRUE(waitUntil([&] {
    for (auto& answer : take(lookup)) answers.push_back(std::move(answer));
    return !lookup.isPending();
  }));
  EXPECT_EQ(answers, (Answers{{"a.example", std::nullopt}, {"b.example", std::nullopt}, {"known.example", kAddress}}));
}

TEST(NameLookupTest, WithoutNamesNothingIsPending) { EXPECT_FALSE(NameLookup({}, onlyKnown).isPending()); }

TEST(NameLookupTest, TheEndDoesNotWaitForANameAndLooksNoOtherUp) {
  std::promise<void> open;
  const auto asked = std::make_shared<std::atomic<int>>(0);
  std::optional<NameLookup> lookup;
  lookup.emplace(std::vector<std::string>{"slow.example", "next.example"},
                 [gate = open.get_future().share(), asked](const std::string&) -> std::optional<IpAddress> {
                   ++*asked;
                   gate.wait();
                   return std::nullopt;
                 });
  EXPECT_TRUE(waitUntil([&] { return *asked == 1; }));
  EXPECT_EQ(take(*lookup), Answers{});
  lookup.reset();  // would not return if it waited for the name
  open.set_value();
  EXPECT_TRUE(waitUntil([&] { return asked.use_count() == 1; })) << "the thread has ended";
  EXPECT_EQ(*asked, 1);
}

TEST(NameLookupTest, AsksTheSystem) {
  EXPECT_EQ(NameLookup::firstAddressOf("127.0.0.1"), IpAddress::ofIpv4({127, 0, 0, 1}));
  EXPECT_EQ(NameLookup::firstAddressOf("no-such-host.invalid"), std::nullopt);
}

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A client and a server over loopback, in virtual time. Lists are read in real time.
class ListedServersTest : public testing::Test {
 protected:
  ListedServersTest() {
    settings_.bind = "127.0.0.1";
    settings_.match.serverName = "Den of Plato";
  }

  ServerAddress address() const { return {"127.0.0.1", server_->port()}; }
  std::string listOf(const ServerIdentity& identity) const {
    return serverListText({listedServer(identity, address(), "Listed"),
                           listedServer(ServerIdentity::random(), {"no-such-host.invalid", 7777}, "Gone")});
  }

  void step(ListedServers& servers) {
    now_ += std::chrono::milliseconds(2);
    servers.update(now_);
    server_->step(TimePoint(now_));
  }
  // Reads the list and steps the server until `done` or for long.
  void follow(ListedServers& servers, const std::function<bool()>& done) {
    EXPECT_TRUE(stepUntil([&] { step(servers); }, done));
  }
  // Steps both until all queries to a server were sent and answered.
  void letAllQueriesPass(ListedServers& servers) {
    const Time end = now_ + ListedSearch::kInterval * (ListedSearch::kMaxTries + 1);
    while (now_ < end) step(servers);
  }

  Time now_ = steadyClock().now();
  ServerSettings settings_;
  std::optional<DedicatedServer> server_{std::in_place, settings_, std::vector<LevelPointer>{endlessLevel()},
                                         Log(LogFormat::kText, [](std::string_view) {})};
};

TEST_F(ListedServersTest, AServerOfTheListAnswersUnderItsKey) {
  const WebServer web([this](std::string_view) { return WebServer::ok(listOf(server_->identity())); });
  ListedServers servers(web.url(), [](const std::string&) { return std::nullopt; });
  EXPECT_TRUE(servers.reading());
  follow(servers, [&] { return !servers.list().empty() && !servers.reading(); });
  ASSERT_EQ(servers.list().size(), 1u);
  EXPECT_EQ(servers.list()[0].listed.name, "Listed");
  EXPECT_EQ(servers.list()[0].answer.info.maxPlayers, settings_.match.maxPlayers);
  EXPECT_THAT(
      servers.faults(),
      ElementsAre("server no-such-host.invalid:7777 of the list is left out: no address was found for its name"));
  EXPECT_EQ(servers.keyOf(address()), server_->identity().publicKey());
  EXPECT_EQ(servers.keyOf({"127.0.0.1", 1}), std::nullopt);
  EXPECT_THAT(textOf(servers.list()), testing::StartsWith(address().text() + "  "));
}

TEST_F(ListedServersTest, AServerWithAnotherKeyIsNotTheListedOne) {
  const WebServer web([this](std::string_view) { return WebServer::ok(listOf(ServerIdentity::random())); });
  ListedServers servers(web.url(), [](const std::string&) { return std::nullopt; });
  follow(servers, [&] { return !servers.reading(); });
  letAllQueriesPass(servers);
  EXPECT_THAT(servers.list(), IsEmpty());
}

// A fleet shares a key, and behind one name there may be many.
TEST_F(ListedServersTest, NamesAreHandedOverAsTheyAreFoundAndDelayNoOthers) {
  std::promise<void> open;
  const auto resolve = [gate = open.get_future().share()](const std::string& host) {
    if (host == "slow.example") gate.wait();
    return std::optional(IpAddress::ofIpv4({127, 0, 0, 1}));
  };
  const WebServer web([this](std::string_view) {
    const ServerIdentity& identity = server_->identity();
    return WebServer::ok(serverListText({listedServer(identity, {"first.example", address().port}, "First"),
                                         listedServer(identity, {"slow.example", address().port}, "Slow"),
                                         listedServer(identity, address(), "Numeric")}));
  });
  std::optional<ListedServers> servers(std::in_place, web.url(), resolve);
  follow(*servers, [&] { return !servers->list().empty(); });
  ASSERT_EQ(servers->list().size(), 1u) << "the other name leads to the same server";
  EXPECT_EQ(servers->list()[0].listed.name, "Numeric");
  EXPECT_TRUE(servers->reading()) << "a name is still looked up";
  servers.reset();  // would not return if it waited for the name
  open.set_value();
}

TEST_F(ListedServersTest, NamesThatAreNotFoundInTimeAreLeftOut) {
  std::promise<void> open;
  const auto resolve = [gate = open.get_future().share()](const std::string&) -> std::optional<IpAddress> {
    gate.wait();
    return std::nullopt;
  };
  const WebServer web([this](std::string_view) { return WebServer::ok(listOf(server_->identity())); });
  ListedServers servers(web.url(), resolve);
  follow(servers, [&] { return !servers.list().empty(); });
  servers.update(now_ + ListedServers::kLookupTime);
  EXPECT_FALSE(servers.reading());
  EXPECT_THAT(servers.faults(),
              ElementsAre("some servers of the list are left out: their names were not resolved in time"));
  open.set_value();
}

TEST_F(ListedServersTest, AReadingIsStoppedWithoutWaitingForIt) {
  std::promise<void> open;
  std::atomic<bool> asked = false;
  const WebServer web([&asked, gate = open.get_future().share()](std::string_view) {
    asked = true;
    gate.wait();
    return std::string();
  });
  ListedServers servers(web.url());
  EXPECT_TRUE(waitUntil([&] { return asked.load(); }));
  EXPECT_FALSE(servers.hasStopped());
  servers.stop();
  EXPECT_TRUE(waitUntil([&] { return servers.hasStopped(); })) << "the web server still keeps it waiting";
  open.set_value();
}

// Whoever signs its own entries can name a machine that has not asked for it, at any ports and under any names.
TEST_F(ListedServersTest, AHostileListTurnsAClientIntoNoFlood) {
  UdpSocket victim("127.0.0.1", 0);
  const ServerIdentity hostile = ServerIdentity::random();
  std::vector<ListedServer> entries;
  for (std::size_t i = 0; i < kMaxListedServers; ++i)
    entries.push_back(listedServer(hostile, {"n" + std::to_string(i) + ".example", victim.address().port}, ""));
  const WebServer web([&](std::string_view) { return WebServer::ok(serverListText(entries)); });
  std::atomic<std::uint32_t> names = 0;
  ListedServers servers(web.url(), [&](const std::string&) {
    ++names;
    return IpAddress::ofIpv4({127, 0, 0, 1});
  });
  follow(servers, [&] { return !servers.reading(); });
  letAllQueriesPass(servers);
  std::size_t bytes = 0;
  while (const auto datagram = victim.receive(now_)) bytes += datagram->bytes.size();
  EXPECT_EQ(names, kMaxListedServers);
  EXPECT_EQ(servers.faults().size(), kMaxListedServers - 1);
  EXPECT_EQ(bytes, ListedSearch::kMaxTries * encode(Query{}).size());
}

TEST_F(ListedServersTest, SaysWhyAListIsNotRead) {
  const WebServer web([](std::string_view) { return WebServer::ok("<html>"); });
  ListedServers servers(web.url("/list"));
  follow(servers, [&] { return !servers.reading(); });
  EXPECT_THAT(servers.faults(),
              ElementsAre("cannot read the list of servers at " + web.url("/list") +
                          ": it is not a list of servers, which is JSON of at most 512 KiB with the key "
                          "\"platonServers\""));
  ListedServers gone("http://127.0.0.1:1/");
  follow(gone, [&] { return !gone.reading(); });
  EXPECT_THAT(gone.faults(), ElementsAre(HasSubstr("cannot read the list of servers at http://127.0.0.1:1/: ")));
}

}  // namespace
}  // namespace platon::listed_servers_test
