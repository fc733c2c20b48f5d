#include "server/app/dedicated_server.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

#include "client/net/enet_link.h"
#include "protocol/transport/client_gate.h"
#include "tests/net/support/datagram_network.h"
#include "tests/net/support/enet_client.h"
#include "tests/net/support/raw_socket.h"
#include "tests/support/test_levels.h"
#include "tests/support/wait_until.h"

namespace platon::dedicated_server_test {
namespace {

using namespace std::chrono_literals;

TimePoint steadyNow() { return std::chrono::steady_clock::now(); }

/// A server and its clients over loopback, all in one thread and in real time.
class DedicatedServerTest : public testing::Test {
 protected:
  void start(std::uint32_t maxPlayers, const std::string& level = farGoalText(), LogFormat format = LogFormat::kText) {
    ServerSettings settings;
    settings.bind = "127.0.0.1";
    settings.match.maxPlayers = maxPlayers;
    server_.emplace(settings, std::vector<LevelPointer>{levelOf(level)},
                    Log(format, [this](std::string_view line) { log_.emplace_back(line); }));
  }

  EnetClient& add(std::optional<FakeClient> client) {
    clients_.push_back(std::make_unique<EnetClient>(server_->port(), std::move(client)));
    return *clients_.back();
  }
  EnetClient& addPlayer(const std::string& name) {
    return add(FakeClient(name, 10, [](std::uint32_t tick) { return static_cast<int>(tick / 7 % 8); }));
  }

  /// Runs until `done`, for at most a minute.
  template <class Done>
  bool run(Done done) {
    const auto step = [this] {
      server_->step(steadyNow());
      for (const auto& client : clients_) client->step();
    };
    return stepUntil(step, done);
  }

  bool plays(EnetClient& client, std::uint32_t ticks) {
    const std::uint32_t before = client.fake().confirmed();
    return run([&] { return client.fake().confirmed() >= before + ticks; }) && client.fake().desyncs() == 0;
  }

  std::uint64_t rejected(std::string_view reason) const {
    for (const Rejection& each : server_->host().rejections().list()) {
      if (each.reason == reason) return each.count;
    }
    ADD_FAILURE() << "no reason " << reason;
    return 0;
  }

  std::optional<DedicatedServer> server_;
  std::vector<std::unique_ptr<EnetClient>> clients_;
  std::vector<std::string> log_;
};

TEST_F(DedicatedServerTest, PlayersPlay) {
  start(4);
  EXPECT_NE(server_->port(), 0);
  EnetClient& ann = addPlayer("Ann");
  EnetClient& ben = addPlayer("Ben");
  EXPECT_TRUE(plays(ann, 40));
  EXPECT_TRUE(plays(ben, 1));
  EXPECT_EQ(server_->match().players(), 2u);
  EXPECT_NE(std::find(log_.begin(), log_.end(), "joined client=1 slot=0 name=\"Ann\""), log_.end());
}

TEST_F(DedicatedServerTest, TellsAListOfServersItsNameAndPlayers) {
  start(4);
  server_->setName("Here");
  EXPECT_TRUE(plays(addPlayer("Ann"), 5));
  const RawSocket list(server_->address());
  list.send(encode(Query{5}));
  std::optional<Info> info;
  EXPECT_TRUE(run([&] { return (info = decodeInfo(list.receive())).has_value(); }));
  EXPECT_EQ(info->nonce, 5u);
  EXPECT_EQ(info->name, "Here");
  EXPECT_EQ(info->players, 1u);
  EXPECT_EQ(info->maxPlayers, 4u);
  EXPECT_EQ(info->identity, server_->identity().publicKey());
}

TEST_F(DedicatedServerTest, RefusesAClientWhenFull) {
  start(1);
  EXPECT_TRUE(plays(addPlayer("Ann"), 5));
  EnetClient& ben = addPlayer("Ben");
  EXPECT_TRUE(run([&] { return ben.disconnected(); }));
  ASSERT_TRUE(ben.fake().refused());
  EXPECT_EQ(ben.fake().refused()->code, RefusalCode::kFull);
}

// ENet took an empty datagram for "nothing waits": 150 of them a second stopped the game for everybody.
TEST_F(DedicatedServerTest, EmptyAndInvalidDatagramsDoNotDisturbTheGame) {
  start(4);
  EnetClient& ann = addPlayer("Ann");
  EXPECT_TRUE(plays(ann, 5));
  const RawSocket attacker(server_->address());
  int sent = 0;
  const auto attack = [&] {
    for (int i = 0; i < 10; ++i, ++sent) {  // so few that the system drops none
      attacker.send({});
      attacker.send(Bytes(3000, 0xff));
      attacker.send(Bytes(50, 0xff));
    }
  };
  EXPECT_TRUE(run([&] {
    if (sent < 300) attack();
    return rejected("seal") == 300;
  })) << rejected("seal");
  EXPECT_TRUE(plays(ann, 5));
}

TEST_F(DedicatedServerTest, AMalformedMessageEndsOnlyItsOwnConnection) {
  start(4);
  EnetClient& ann = addPlayer("Ann");
  EnetClient& eve = addPlayer("Eve");
  EXPECT_TRUE(run([&] { return server_->match().players() == 2; }));
  eve.sendRaw({1, 2, 3, 4, 5, 6, 7, 8}, true);
  EXPECT_TRUE(run([&] { return server_->host().rejections().message == 1; }));
  EXPECT_EQ(server_->match().players(), 1u);
  EXPECT_TRUE(run([&] { return eve.disconnected(); }));
  ASSERT_TRUE(eve.fake().bye());
  EXPECT_EQ(eve.fake().bye()->code, ByeCode::kRemoved);
  EXPECT_TRUE(plays(ann, 10));
}

// A Hello after the malformed message would otherwise let the client join again.
TEST_F(DedicatedServerTest, MessagesOfAClosingConnectionAreIgnored) {
  start(4);
  EnetClient& eve = addPlayer("Eve");
  EXPECT_TRUE(plays(eve, 2));
  eve.sendRaw({1, 2, 3, 4, 5, 6, 7, 8}, true);
  eve.sendRaw(encode(Hello{}), true);
  eve.sendRaw({1, 2, 3, 4, 5, 6, 7, 8}, true);
  EXPECT_TRUE(run([&] { return eve.disconnected(); }));
  EXPECT_EQ(server_->match().players(), 0u);
  EXPECT_EQ(server_->host().rejections().message, 1u);
}

// Repeated Leave and Hello on one connection must not cause a Roster to all clients each time.
TEST_F(DedicatedServerTest, AClientThatHasLeftCannotJoinAgainOverTheSameConnection) {
  start(4);
  EnetClient& eve = addPlayer("Eve");
  EXPECT_TRUE(plays(eve, 2));
  for (int again = 0; again < 20; ++again) {
    eve.sendRaw(encode(Leave{}), true);
    eve.sendRaw(encode(Hello{}), true);
  }
  EXPECT_TRUE(run([&] { return eve.disconnected(); }));
  EXPECT_EQ(server_->match().players(), 0u);
  EXPECT_EQ(std::count_if(log_.begin(), log_.end(), [](const std::string& line) { return line.starts_with("joined"); }),
            1);
}

TEST_F(DedicatedServerTest, AFloodIsDroppedAndOtherClientsKeepPlaying) {
  start(4);
  EnetClient& ann = addPlayer("Ann");
  EnetClient& eve = addPlayer("Eve");
  EXPECT_TRUE(run([&] { return server_->match().players() == 2; }));
  const std::vector<std::uint8_t> useless = encode(LevelRequest{1});
  for (int i = 0; i < 600; ++i) eve.sendRaw(useless, false);
  EXPECT_TRUE(run([&] { return rejected("excess") > 100; }));
  EXPECT_TRUE(plays(ann, 10));
}

TEST_F(DedicatedServerTest, AConnectionThatDoesNotJoinInTimeEnds) {
  start(4);
  EnetClient& silent = add(std::nullopt);
  EXPECT_TRUE(run([&] { return silent.connected(); }));
  const TimePoint connected = steadyNow();
  for (TimePoint now = connected; rejected("idle") == 0; now += 100ms) {
    silent.step();  // acknowledges, but sends no message
    ASSERT_LT(now, connected + 12s);
    server_->step(now);
  }
  EXPECT_TRUE(run([&] { return silent.disconnected(); }));
}

TEST_F(DedicatedServerTest, StoppingTellsTheClientsTheReason) {
  start(4);
  EnetClient& ann = addPlayer("Ann");
  EXPECT_TRUE(plays(ann, 5));
  std::thread stopping([this] { server_->stop("the server stops"); });
  EXPECT_TRUE(stepUntil([&] { ann.step(); }, [&] { return ann.fake().bye().has_value(); }));
  stopping.join();
  ASSERT_TRUE(ann.fake().bye());
  EXPECT_EQ(ann.fake().bye()->reason, "the server stops");
}

TEST_F(DedicatedServerTest, LogsTheTickTimesWhenItStops) {
  start(4);
  const TimePoint begin = steadyNow();
  EXPECT_TRUE(plays(addPlayer("Ann"), 20));
  const TickTimes& times = server_->tickTimes();
  const std::uint64_t ticks = times.count();
  EXPECT_GE(ticks, 20u);
  EXPECT_GE(times.longest(), times.quantile(0.5));
  EXPECT_LT(std::chrono::microseconds(times.longest()), steadyNow() - begin);
  clients_.clear();
  server_->stop("the server stops");
  EXPECT_EQ(log_.back(), "tick times ticks=" + std::to_string(ticks) + " p50Us=" + std::to_string(times.quantile(0.5)) +
                             " p99Us=" + std::to_string(times.quantile(0.99)) +
                             " longestUs=" + std::to_string(times.longest()));
}

TEST_F(DedicatedServerTest, TheLogHasTheTicksOfARoundAsANumber) {
  start(4, nearGoalText(), LogFormat::kJson);
  EnetClient& ann = addPlayer("Ann");
  EXPECT_TRUE(run([&] { return ann.fake().roundEnd().has_value(); }));
  const std::string ticks = std::to_string(ann.fake().roundEnd()->tick);
  EXPECT_EQ(
      std::count_if(log_.begin(), log_.end(),
                    [&ticks](const std::string& line) {
                      return line.ends_with(R"("message":"round over","ticks":)" + ticks + R"(,"cause":"finished"})");
                    }),
      1);
}

TEST_F(DedicatedServerTest, AServerWithoutPlayersRunsNoTicks) {
  start(4);
  for (int i = 0; i < 10; ++i) server_->step(steadyNow() + i * 100ms);
  EXPECT_EQ(server_->tickTimes().count(), 0u);
}

TEST_F(DedicatedServerTest, ADisconnectedPlayerStaysForAMinute) {
  start(4);
  EXPECT_TRUE(plays(addPlayer("Ann"), 2));
  clients_.clear();
  const TimePoint disconnectedAt = steadyNow();
  const auto pass = [&](int from, int to) {
    for (int i = from; i < to; ++i) server_->step(disconnectedAt + i * 10ms);
  };
  pass(0, 1000);  // the connection has timed out
  EXPECT_EQ(server_->match().players(), 0u);
  EXPECT_FALSE(server_->match().idle());
  pass(1000, 9000);
  EXPECT_TRUE(server_->match().idle());
}

/// A server in a simulated network, in virtual time.
class BannedAddressTest : public testing::Test {
 protected:
  BannedAddressTest() { server_.refuseBanned(bans_); }

  void knock(const SocketAddress& own) {
    ClientGate client(network_.socket(own), {kServer}, {}, KeyPair::random());
    for (int roundTrip = 0; roundTrip < 3; ++roundTrip) {
      client.update(timeOf(now_));
      server_.step(now_);
      client.receive(timeOf(now_));
    }
    EXPECT_EQ(client.state(), ClientGate::State::kRefused);
  }

  static inline const SocketAddress kServer = addressAt("198.51.100.1", 7777);

  BanList bans_ = std::get<BanList>(BanList::parse("192.0.2.0/24 too loud\n2001:db8::/32\n"));
  DatagramNetwork network_;
  std::vector<std::string> log_;
  DedicatedServer server_{network_.socket(kServer),
                          {},
                          {levelOf(farGoalText())},
                          {LogFormat::kText, [this](std::string_view line) { log_.emplace_back(line); }}};
  TimePoint now_ = steadyNow();
};

TEST_F(BannedAddressTest, TheLogTellsOfTheFirstRefusalOfEachHousehold) {
  const auto tellsNow = [this](const char* own) {
    log_.clear();
    knock(addressAt(own, 4000));
    now_ += 10s;
    const auto told =
        std::find_if(log_.begin(), log_.end(), [](const auto& line) { return line.starts_with("refused"); });
    return told == log_.end() ? std::string() : *told;
  };
  EXPECT_EQ(tellsNow("192.0.2.7"), R"(refused banned address address="192.0.2.7" ban="192.0.2.0/24")");
  EXPECT_EQ(tellsNow("192.0.2.7"), "");
  EXPECT_EQ(tellsNow("2001:db8::1"), R"(refused banned address address="2001:db8::1" ban="2001:db8::/32")");
  EXPECT_EQ(tellsNow("2001:db8::2"), "");
  now_ += std::chrono::hours(1);
  EXPECT_EQ(tellsNow("192.0.2.7"), R"(refused banned address address="192.0.2.7" ban="192.0.2.0/24")");
  EXPECT_EQ(server_.host().rejections().banned, 5u);
}

// The datagram of a client also arrives from a banned address, as if somebody had forged it.
TEST_F(BannedAddressTest, AForgedAddressIsNotLogged) {
  ClientGate client(network_.socket(addressAt("203.0.113.1", 4000)), {kServer}, {}, KeyPair::random());
  for (int roundTrip = 0; roundTrip < 3; ++roundTrip) {
    client.update(timeOf(now_));
    server_.step(now_);
    client.receive(timeOf(now_));
  }
  ASSERT_EQ(client.state(), ClientGate::State::kOpen);
  network_.setFilter([](const auto& each) { return each.to != kServer; });
  client.send(Bytes(40), timeOf(now_));
  network_.inject(addressAt("192.0.2.7", 4000), kServer, network_.sent().back().bytes);
  server_.step(now_);
  network_.setFilter({});
  log_.clear();
  knock(addressAt("192.0.2.7", 4000));
  EXPECT_EQ(log_, std::vector<std::string>{R"(refused banned address address="192.0.2.7" ban="192.0.2.0/24")"});
}

TEST_F(BannedAddressTest, AConnectionFromBeforeTheBanCannotJoin) {
  bans_ = BanList();
  EnetLink client(network_.socket(addressAt("192.0.2.7", 4000)), {kServer}, {});
  std::vector<ToClient> received;
  const auto run = [&](EnetLink::State state) {
    for (int ms = 0; ms < 20000 && client.state() != state; ++ms) {
      now_ += 1ms;
      server_.step(now_);
      client.service(timeOf(now_), [&](std::span<const std::uint8_t> bytes) {
        if (auto message = decodeToClient({bytes.begin(), bytes.end()})) received.push_back(std::move(*message));
      });
    }
    return client.state() == state;
  };
  ASSERT_TRUE(run(EnetLink::State::kConnected));
  bans_ = std::get<BanList>(BanList::parse("192.0.2.7 too loud\n"));
  client.send(encode(Hello{}), true);
  EXPECT_TRUE(run(EnetLink::State::kClosed));
  const Refused expected{RefusalCode::kOther, "you are banned from this server: too loud"};
  EXPECT_EQ(received, std::vector<ToClient>{expected});
  EXPECT_TRUE(server_.match().idle());
  EXPECT_EQ(server_.host().rejections().banned, 1u);
}

}  // namespace
}  // namespace platon::dedicated_server_test
