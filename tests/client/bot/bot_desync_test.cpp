#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <vector>

#include "client/bot/bot_fleet.h"
#include "client/time/steady_now.h"
#include "server/app/tick_clock.h"
#include "server/match/match.h"
#include "server/net/host.h"
#include "tests/sim/verification.h"
#include "tests/support/files.h"
#include "tests/support/input_flipper.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_level.h"

namespace platon {
namespace {

constexpr const char* kLoopback = "127.0.0.1";

HostSettings loopback() {
  HostSettings settings;
  settings.bind = kLoopback;
  return settings;
}

/// A server on a socket that once tells a wrong input.
class LyingServer {
 public:
  ServerAddress address() const { return {kLoopback, host_.port()}; }

  void step() {
    const TimePoint now = std::chrono::steady_clock::now();
    for (const HostEvent& event : host_.service(now)) take(event);
    if (clock_.take(now)) match_.tick();
    for (Outgoing& message : match_.takeOutgoing()) {
      flipper_(message.bytes);
      host_.send(message.client, message.reliable, message.bytes);
    }
    host_.flush(now);
  }

 private:
  void take(const HostEvent& event) {
    if (event.disconnected) return match_.disconnect(event.client);
    if (const auto message = decodeToServer(event.bytes)) match_.receive(event.client, *message);
    host_.admit(event.client);
  }

  Host host_{loopback(), std::chrono::steady_clock::now()};
  Match match_{LevelRotation({endlessLevel()}), {4, "Test"}};
  TickClock clock_{std::chrono::steady_clock::now()};
  InputFlipper flipper_{60, 0, {}};
};

// The server steps whenever the bots sleep.
TEST(BotMismatch, IsWrittenToTheFolderAndPutRight) {
  const TemporaryFolder folder;
  LyingServer server;
  const Clock clock{steadyClock().now, [&](Moment until) {
                      server.step();
                      steadyClock().sleepUntil(until);
                    }};
  FleetOptions options;
  options.seconds = 4;
  options.desyncFolder = folder.path();
  testing::internal::CaptureStderr();
  const std::vector<BotResult> results = BotFleet(options, server.address(), clock).play();
  const std::string said = testing::internal::GetCapturedStderr();
  ASSERT_EQ(results.size(), 1u);
  EXPECT_EQ(results[0].round.desyncs, 1u);
  EXPECT_EQ(results[0].round.resyncs, 1u);
  EXPECT_EQ(results[0].ending, std::nullopt);
  EXPECT_TRUE(said.starts_with("platon-bot: bot 1: round 1: the game was not the server's after tick ")) << said;
  EXPECT_TRUE(said.ends_with(" on the server; see " + (folder / "desync-1.txt").string() + "\n")) << said;
  EXPECT_NE(readText(folder / "desync-1.txt").find("\n! entity 0 position"), std::string::npos);
  const std::vector<std::uint8_t> bytes = readBytes(folder / "desync-1.recording");
  const sim::Verification found = sim::Verifier(bytes).run();
  EXPECT_EQ(found.fault, "");
  EXPECT_FALSE(found.divergence.has_value());
}

}  // namespace
}  // namespace platon
