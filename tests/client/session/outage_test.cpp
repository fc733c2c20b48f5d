#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "client/net/enet_link.h"
#include "client/net/network_conditions.h"
#include "client/play/match/live_match.h"
#include "client/session/network_client.h"
#include "client/time/steady_now.h"
#include "protocol/to_client.h"
#include "protocol/transport/udp_socket.h"
#include "server/app/dedicated_server.h"
#include "server/net/host.h"
#include "tests/support/environment_variable.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_levels.h"

namespace platon::outage_test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr const char* kLoopback = "127.0.0.1";
constexpr Time kStep = milliseconds(4);
constexpr Time kMaxResumeTime = seconds(1);  // from when the server is reachable again to the first confirmed tick
const Controls kRight = [](const Game&, std::uint32_t) { return Input{Input::kRight}; };

LinkQuality delayed() {
  LinkQuality quality;
  quality.delayMs = 30;
  return quality;
}

LinkQuality fullLoss() {
  LinkQuality quality;
  quality.lossPercent = 100;
  return quality;
}

/// A server, a relay and clients on loopback sockets, in one thread and in virtual time.
class Outage : public testing::Test {
 protected:
  Outage() { startServer(0, 4); }

  void startServer(std::uint16_t port, std::uint32_t maxPlayers) {
    ServerSettings settings;
    settings.bind = kLoopback;
    settings.port = port;
    settings.identity = identity_;
    settings.match.maxPlayers = maxPlayers;
    server_.emplace(settings, std::vector<LevelPointer>{endlessLevel()},
                    Log(LogFormat::kText, [this](std::string_view line) { log_ += std::string(line) + "\n"; }));
    port_ = server_->port();
  }

  // Stops the server without notifying the clients.
  void stopServerSilently() { server_.reset(); }

  ServerAddress address() const { return {kLoopback, port_}; }

  // Starts a client behind the relay and lets it play for a second.
  void play() {
    relay_.emplace(address(), delayed(), 1);
    client_.emplace(enetLinks(address(), relay_->address()), NetworkClient::Profile{"Ann"}, now_);
    ASSERT_TRUE(runUntil(seconds(3), [this] { return ticks() > 60; }));
  }

  void step() {
    now_ += kStep;
    if (server_) server_->step(TimePoint(now_));
    if (relay_) relay_->pump(now_);
    if (client_) client_->update(now_, kRight);
    if (other_) other_->update(now_, kRight);
    if (relay_) relay_->pump(now_);
  }

  void run(Time duration) {
    for (const Time end = now_ + duration; now_ < end;) step();
  }

  bool runUntil(Time timeout, const std::function<bool()>& done) {
    for (const Time end = now_ + timeout; now_ < end && !done();) step();
    return done();
  }

  // Time until the client confirms a further tick.
  Time timeToPlay() {
    const Time begun = now_;
    const std::uint32_t before = ticks();
    EXPECT_TRUE(runUntil(seconds(20), [this, before] { return ticks() > before; }));
    return now_ - begun;
  }

  std::uint32_t ticks() const {
    return client_->session() == nullptr ? 0 : client_->session()->predictionStatistics().confirmedTicks;
  }
  std::uint32_t slot() const { return client_->session()->welcome()->slot; }
  bool logged(const char* text) const { return log_.find(text) != std::string::npos; }

  Time now_ = steadyClock().now();
  std::string log_;
  const ServerIdentity identity_ = ServerIdentity::random();
  std::optional<DedicatedServer> server_;
  std::uint16_t port_ = 0;
  std::optional<LossyRelay> relay_;
  std::optional<NetworkClient> client_, other_;
};

// The durations cover all phases of the client's attempts to reconnect.
TEST_F(Outage, ResumesWithinASecondAfterTotalLoss) {
  Time longest{};
  std::uint32_t outages = 0;
  play();
  for (const int ms : {2000, 3300, 4100, 4700, 6000, 8990, 9100, 13700, 14001, 26300, 33500, 55000}) {
    SCOPED_TRACE(ms);
    const PredictionStatistics before = client_->session()->predictionStatistics();
    relay_->setQuality(fullLoss());
    run(milliseconds(ms));
    EXPECT_EQ(client_->outage().has_value(), ms > 4000) << client_->outage().value_or("none");
    relay_->setQuality(delayed());
    const Time took = timeToPlay();
    EXPECT_LE(took, kMaxResumeTime);
    longest = std::max(longest, took);
    run(seconds(2));
    outages += ms > 4000 ? 1 : 0;
    EXPECT_EQ(client_->outage(), std::nullopt);
    EXPECT_EQ(client_->ending(), std::nullopt);
    EXPECT_GT(client_->session()->predictionStatistics().confirmedTicks, before.confirmedTicks);
    EXPECT_EQ(client_->session()->roundStatistics().desyncs, 0u);
    EXPECT_EQ(slot(), 0u);
    EXPECT_EQ(server_->match().players(), 1u);
  }
  EXPECT_GE(client_->resumes(), outages);
  EXPECT_FALSE(logged("left"));
  EXPECT_EQ(log_.find("joined"), log_.rfind("joined"));
  std::printf("at most %lld ms, %u resumes\n", static_cast<long long>(longest / milliseconds(1)), client_->resumes());
}

// The last scene is also shown between Welcome and the full state, when the new round has no player yet.
TEST_F(Outage, ShowsTheLastSceneUntilThePlayerIsResumed) {
  relay_.emplace(address(), delayed(), 1);
  const TemporaryFolder folder;
  const EnvironmentVariable data("XDG_DATA_HOME", folder.path().string());
  const EnvironmentVariable cache("XDG_CACHE_HOME", folder.path().string());
  LiveMatch match(ClientOptions(), {.server = relay_->address()}, {[this] { return now_; }, [](Time) {}});
  const auto showsThePlayer = [&] {
    step();
    match.update(false, kRight);
    const std::optional<Scene> scene = match.scene();
    return scene && !scene->players.empty() && scene->players.back().local;
  };
  const Time settled = now_ + seconds(1);
  while (now_ < settled) showsThePlayer();
  for (const int ms : {500, 507, 514}) {
    relay_->setQuality(fullLoss());
    while (!match.client().outage()) ASSERT_TRUE(showsThePlayer());
    relay_->setQuality(delayed());
    while (match.client().outage()) ASSERT_TRUE(showsThePlayer());
    for (const Time end = now_ + milliseconds(ms); now_ < end;) ASSERT_TRUE(showsThePlayer());
  }
  EXPECT_EQ(match.client().resumes(), 3u);
}

TEST_F(Outage, IsDetectedByTimeout) {
  play();
  relay_->setQuality(fullLoss());
  ASSERT_TRUE(runUntil(Session::kTimeout + milliseconds(100), [this] { return client_->outage().has_value(); }));
  EXPECT_GT(ticks(), 60u);
  ASSERT_NE(client_->session(), nullptr);  // the last session
  EXPECT_TRUE(client_->session()->ending().has_value());
}

TEST_F(Outage, RejoinsARestartedServerWithinASecond) {
  for (const int ms : {500, 5100, 9900, 31000}) {
    SCOPED_TRACE(ms);
    client_.reset();
    play();
    stopServerSilently();
    run(milliseconds(ms));
    startServer(port_, 4);
    const Time begun = now_;
    ASSERT_TRUE(runUntil(seconds(10), [this] { return server_->match().players() == 1; }));
    // The client detects a restarted server at the latest when its timeout has passed.
    EXPECT_LE(now_ - begun, ms < 4000 ? Session::kTimeout : kMaxResumeTime);
    EXPECT_LE(timeToPlay(), kMaxResumeTime);
    EXPECT_EQ(client_->session()->roundStatistics().desyncs, 0u);
    run(seconds(1));
  }
}

TEST_F(Outage, LastsWhileTheServerIsFull) {
  play();
  stopServerSilently();
  run(seconds(5));
  startServer(port_, 1);
  other_.emplace(enetLinks(address()), NetworkClient::Profile{"Ben"}, now_);
  relay_->setQuality(fullLoss());
  ASSERT_TRUE(runUntil(seconds(2), [this] { return server_->match().players() == 1; }));
  relay_->setQuality(delayed());
  run(seconds(30));
  EXPECT_EQ(client_->ending(), std::nullopt);
  EXPECT_EQ(client_->outage(), "the server refused this client: the server is full (1 players): try again later");
  EXPECT_TRUE(logged("refused"));
  other_->leave();
  const std::uint32_t before = ticks();
  ASSERT_TRUE(runUntil(NetworkClient::kMaxPause + kMaxResumeTime, [&] { return ticks() > before; }));
  EXPECT_EQ(client_->resumes(), 1u);
}

TEST_F(Outage, AsksAFullServerLessAndLessOften) {
  play();
  stopServerSilently();
  run(seconds(5));
  startServer(port_, 1);
  relay_->setQuality(fullLoss());
  other_.emplace(enetLinks(address()), NetworkClient::Profile{"Ben"}, now_);
  ASSERT_TRUE(runUntil(seconds(2), [this] { return server_->match().players() == 1; }));
  relay_->setQuality(delayed());
  run(seconds(30));
  std::size_t refusals = 0;
  for (std::size_t at = 0; (at = log_.find("refused", at)) != std::string::npos; ++at) ++refusals;
  EXPECT_GE(refusals, 12u);
  EXPECT_LE(refusals, 18u);
}

TEST_F(Outage, EndsWithAServerOfAnotherVersion) {
  play();
  stopServerSilently();
  run(seconds(5));
  Host host(std::make_unique<UdpSocket>(kLoopback, port_), identity_, {}, now_);
  const auto refuse = [&] {
    for (const HostEvent& event : host.service(now_)) {
      if (event.disconnected) continue;
      host.send(event.client, true, encode(Refused{RefusalCode::kWrongRules, "update your client"}));
      host.close(event.client, now_);
    }
    host.flush(now_);
    return client_->ending().has_value();
  };
  ASSERT_TRUE(runUntil(seconds(5), refuse));
  EXPECT_EQ(client_->ending(), "the server refused this client: update your client");
  EXPECT_TRUE(client_->welcomed());
}

TEST_F(Outage, TheClientCanLeave) {
  for (const int ms : {4500, 9100}) {
    client_.reset();
    play();
    relay_->setQuality(fullLoss());
    run(milliseconds(ms));
    ASSERT_TRUE(client_->outage().has_value());
    client_->leave();
    EXPECT_TRUE(client_->closed());
    run(seconds(2));
    EXPECT_TRUE(client_->closed());
    relay_->setQuality(delayed());
    run(seconds(2));
    EXPECT_EQ(server_->match().players(), 0u);  // the client did not resume its player
    EXPECT_FALSE(server_->match().idle());      // the server still keeps it
  }
}

TEST_F(Outage, ThePlayerIsRemovedAfterAMinute) {
  play();
  relay_->setQuality(fullLoss());
  run(seconds(6));
  ASSERT_TRUE(client_->outage().has_value());
  client_.reset();
  run(seconds(70));
  EXPECT_TRUE(server_->match().idle());
  EXPECT_TRUE(logged("left"));
}

TEST_F(Outage, ACrashedClientResumesWithItsToken) {
  for (const int ms : {0, 2000, 50000}) {
    SCOPED_TRACE(ms);
    log_.clear();
    play();
    const SessionToken token = client_->token();
    client_.reset();  // without Leave
    run(milliseconds(ms));
    other_.emplace(enetLinks(address()), NetworkClient::Profile{"Ben"}, now_);
    run(seconds(1));  // another player joins
    const Time begun = now_;
    client_.emplace(enetLinks(address()), NetworkClient::Profile{"Ann", {}, token}, now_);
    EXPECT_EQ(client_->token(), token);
    ASSERT_TRUE(runUntil(kMaxResumeTime, [this] { return client_->session() != nullptr && ticks() > 0; }));
    std::printf("after %lld ms\n", static_cast<long long>((now_ - begun) / milliseconds(1)));
    EXPECT_EQ(slot(), 0u);
    EXPECT_TRUE(logged("resumed"));
    EXPECT_EQ(client_->resumes(), 0u);
    run(seconds(2));
    EXPECT_EQ(client_->session()->roundStatistics().desyncs, 0u);
    EXPECT_EQ(server_->match().players(), 2u);
    for (auto* leaver : {&client_, &other_}) (*leaver)->leave();
    run(seconds(2));
    ASSERT_TRUE(server_->match().idle());
  }
}

TEST_F(Outage, EveryClientGetsItsOwnRandomToken) {
  play();
  other_.emplace(enetLinks(address()), NetworkClient::Profile{"Ben"}, now_);
  EXPECT_NE(other_->token(), client_->token());
}

}  // namespace
}  // namespace platon::outage_test
