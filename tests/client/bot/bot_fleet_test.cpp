#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <vector>

#include "client/bot/bot_fleet.h"
#include "protocol/transport/udp_socket.h"
#include "server/app/tick_clock.h"
#include "server/match/match.h"
#include "server/net/host.h"
#include "tests/sim/verify/verification.h"
#include "tests/support/files.h"
#include "tests/support/input_flipper.h"
#include "tests/support/loopback_server.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_level.h"

namespace platon::bot_fleet_test {
namespace {

/// A server on a socket that sends one wrong input.
class FaultyServer {
 public:
  static constexpr TimePoint kStart{};

  ServerAddress address() const { return {"127.0.0.1", host_.address().port}; }

  void step(TimePoint now) {
    for (const HostEvent& event : host_.service(momentOf(now))) take(event);
    if (clock_.take(now)) match_.tick();
    for (const Outgoing& message : match_.takeOutgoing()) {
      std::vector<std::uint8_t> bytes(message.bytes.begin(), message.bytes.end());
      flipper_(bytes);
      host_.send(message.client, message.reliable, bytes);
    }
    host_.flush(momentOf(now));
  }

 private:
  void take(const HostEvent& event) {
    if (event.disconnected) return match_.disconnect(event.client);
    if (const auto message = decodeToServer(event.bytes)) match_.receive(event.client, *message);
    host_.admit(event.client);
  }

  Host host_{std::make_unique<UdpSocket>("127.0.0.1", 0), ServerIdentity::random(), {}, momentOf(kStart)};
  Match match_{LevelRotation({endlessLevel()}), {4, "Test"}};
  TickClock clock_{kStart};
  InputFlipper flipper_{60, 0, {}};
};

// The server steps whenever the bots sleep, in virtual time.
TEST(BotFleet, WritesADesyncReportAndResyncs) {
  const TemporaryFolder folder;
  FaultyServer server;
  Moment now{};  // FaultyServer::kStart
  const Clock clock{[&] { return now; },
                    [&](Moment until) {
                      server.step(TimePoint(now));
                      now = until;
                    }};
  FleetOptions options;
  options.seconds = 4;
  options.desyncFolder = folder.path();
  testing::internal::CaptureStderr();
  const std::vector<BotResult> results = BotFleet(options, server.address(), clock).play();
  const std::string log = testing::internal::GetCapturedStderr();
  ASSERT_EQ(results.size(), 1u);
  EXPECT_EQ(results[0].round.desyncs, 1u);
  EXPECT_EQ(results[0].round.resyncs, 1u);
  EXPECT_EQ(results[0].ending, std::nullopt);
  EXPECT_TRUE(log.starts_with("platon-bot: bot 1: round 1: desync at tick ")) << log;
  EXPECT_TRUE(log.ends_with(" on the server; see " + (folder / "desync-1.txt").string() + "\n")) << log;
  EXPECT_NE(readText(folder / "desync-1.txt").find("\n! entity 0 position"), std::string::npos);
  const std::vector<std::uint8_t> bytes = readBytes(folder / "desync-1.recording");
  const sim::Verification found = sim::Verifier(bytes).run();
  EXPECT_EQ(found.fault, "");
  EXPECT_FALSE(found.divergence.has_value());
}

FleetOptions threeBots(bool hollow) {
  FleetOptions options;
  options.count = 3;
  options.seconds = 4;
  options.hollow = hollow;
  return options;
}

TEST(BotFleet, PlaysForTheGivenTimeAndLeaves) {
  for (const bool hollow : {false, true}) {
    LoopbackServer server;
    const Moment start = server.clock().now();
    const std::vector<BotResult> results = BotFleet(threeBots(hollow), server.address(), server.clock()).play();
    const double seconds = toSeconds(server.clock().now() - start);
    EXPECT_GE(seconds, 4);
    EXPECT_LT(seconds, 4.5);  // the bots leave before the timeout
    ASSERT_EQ(results.size(), 3u);
    for (const BotResult& result : results) {
      EXPECT_EQ(result.ending, std::nullopt);
      EXPECT_GT(result.prediction.confirmedTicks, 100u);
    }
    EXPECT_EQ(server.server().match().players(), 0u);
  }
}

// A derivation takes 64 MiB and a tenth of a second, in which no other bot plays.
TEST(BotFleet, DerivesTheKeyOfThePasswordOnce) {
  for (const bool hollow : {false, true}) {
    LoopbackServer server([](std::string_view) {}, "sesame");
    FleetOptions options = threeBots(hollow);
    options.knowledge.password = Password("sesame");
    for (const BotResult& result : BotFleet(options, server.address(), server.clock()).play()) {
      EXPECT_TRUE(result.joined);
      EXPECT_EQ(result.ending, std::nullopt);
    }
    EXPECT_EQ(options.knowledge.password.derivations(), 1u);
  }
}

TEST(BotFleet, CountsBotsThatNeverJoined) {
  Moment now{};
  const Clock clock{[&] { return now; }, [&](Moment until) { now = until; }};
  FleetOptions options = threeBots(false);
  options.seconds = 7;
  const std::vector<BotResult> results = BotFleet(options, {"127.0.0.1", 1}, clock).play();
  ASSERT_EQ(results.size(), 3u);
  for (const BotResult& result : results) {
    EXPECT_FALSE(result.joined);
    EXPECT_TRUE(result.ending.has_value());
  }
}

}  // namespace
}  // namespace platon::bot_fleet_test
