#include "client/lobby/listed_servers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "client/time/steady_now.h"
#include "server/app/dedicated_server.h"
#include "tests/client/lobby/web_server.h"
#include "tests/support/test_level.h"

namespace platon {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr Moment kEnd = std::chrono::seconds(20);

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

  // Reads the list and steps the server until `done` or for long.
  void follow(ListedServers& servers, const std::function<bool()>& done) {
    const Clock clock = steadyClock();
    const Moment begin = clock.now();
    for (Moment now = begin; now < begin + kEnd && !done(); now = clock.now()) {
      servers.update(now);
      server_->step(TimePoint(now));
      servers.wait(std::chrono::milliseconds(2));
    }
  }

  ServerSettings settings_;
  std::optional<DedicatedServer> server_{std::in_place, settings_, std::vector<LevelPointer>{endlessLevel()},
                                         Log(LogFormat::kText, [](std::string_view) {})};
};

TEST_F(ListedServersTest, AServerOfTheListAnswersUnderItsKey) {
  const WebServer web([this](std::string_view) { return WebServer::ok(listOf(server_->identity())); });
  ListedServers servers(web.url());
  EXPECT_TRUE(servers.reading());
  follow(servers, [&] { return !servers.list().empty(); });
  ASSERT_EQ(servers.list().size(), 1u);
  EXPECT_EQ(servers.list()[0].listed.name, "Listed");
  EXPECT_EQ(servers.list()[0].answer.info.maxPlayers, settings_.match.maxPlayers);
  EXPECT_THAT(servers.faults(), IsEmpty());
  EXPECT_EQ(servers.keyOf(address()), server_->identity().publicKey());
  EXPECT_EQ(servers.keyOf({"127.0.0.1", 1}), std::nullopt);
  EXPECT_THAT(textOf(servers.list()), testing::StartsWith(address().text() + "  "));
}

TEST_F(ListedServersTest, AServerWithAnotherKeyIsNotTheListedOne) {
  const WebServer web([this](std::string_view) { return WebServer::ok(listOf(ServerIdentity::random())); });
  ListedServers servers(web.url());
  const Clock clock = steadyClock();
  const Moment end = clock.now() + std::chrono::seconds(1);
  follow(servers, [&] { return !servers.reading() && clock.now() > end; });
  EXPECT_THAT(servers.list(), IsEmpty());
  EXPECT_FALSE(servers.reading());
}

TEST_F(ListedServersTest, SaysWhyAListIsNotRead) {
  const WebServer web([](std::string_view) { return WebServer::ok("<html>"); });
  ListedServers servers(web.url("/list"));
  follow(servers, [&] { return !servers.reading(); });
  EXPECT_THAT(servers.faults(), ElementsAre("cannot read the list of servers at " + web.url("/list") +
                                            ": it is no list of servers: JSON of at most 512 KiB with the key "
                                            "\"platonServers\""));
  ListedServers gone("http://127.0.0.1:1/");
  follow(gone, [&] { return !gone.reading(); });
  EXPECT_THAT(gone.faults(), ElementsAre(HasSubstr("cannot read the list of servers at http://127.0.0.1:1/: ")));
}

}  // namespace
}  // namespace platon
