#include "client/bot/bot_fleet.h"

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <vector>

#include "protocol/program_error.h"
#include "protocol/transport/udp_socket.h"
#include "server/base/tick_clock.h"
#include "server/match/match.h"
#include "server/net/host.h"
#include "tests/net/support/input_flipper.h"
#include "tests/net/support/loopback_server.h"
#include "tests/sim/verify/verification.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_levels.h"

namespace platon::bot_fleet_test {
namespace {

/// A server on a socket that sends one wrong input.
class FaultyServer {
 public:
  static constexpr TimePoint kStart{};

  ServerAddress address() const { return {"127.0.0.1", host_.address().port}; }

  void step(TimePoint now) {
    for (const HostEvent& event : host_.service(timeOf(now))) take(event);
    if (clock_.take(now)) match_.tick();
    for (const Outgoing& message : match_.takeOutgoing()) {
      std::vector<std::uint8_t> bytes(message.bytes.begin(), message.bytes.end());
      flipper_(bytes);
      host_.send(message.client, message.reliable, bytes);
    }
    host_.flush(timeOf(now));
  }

 private:
  void take(const HostEvent& event) {
    if (event.disconnected) return match_.disconnect(event.client);
    if (const auto message = decodeToServer(event.bytes)) match_.receive(event.client, *message);
    host_.admit(event.client);
  }

  Host host_{std::make_unique<UdpSocket>("127.0.0.1", 0), ServerIdentity::random(), {}, timeOf(kStart)};
  Match match_{LevelRotation({endlessLevel()}), {4, "Test"}};
  TickClock clock_{kStart};
  InputFlipper flipper_{60, 0, {}};
};

// The server steps whenever the bots sleep, in virtual time.
TEST(BotFleet, WritesADesyncReportAndResyncs) {
  const TemporaryFolder folder;
  FaultyServer server;
  Time now{};  // FaultyServer::kStart
  const Clock clock{[&] { return now; },
                    [&](Time until) {
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
    const Time start = server.clock().now();
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
  Time now{};
  const Clock clock{[&] { return now; }, [&](Time until) { now = until; }};
  FleetOptions options = threeBots(false);
  options.seconds = 7;
  const std::vector<BotResult> results = BotFleet(options, {"127.0.0.1", 1}, clock).play();
  ASSERT_EQ(results.size(), 3u);
  for (const BotResult& result : results) {
    EXPECT_FALSE(result.joined);
    EXPECT_TRUE(result.ending.has_value());
  }
}

LinkQuality read(const std::vector<std::string>& words) {
  ProgramOptions program("bots", "");
  LinkQuality quality;
  addConditionOptions(program, quality);
  std::vector<const char*> arguments{"bots"};
  for (const std::string& word : words) arguments.push_back(word.c_str());
  program.read(static_cast<int>(arguments.size()), arguments.data());
  return quality;
}

// The error message; empty if the arguments are accepted.
std::string refusal(const std::vector<std::string>& words) {
  try {
    read(words);
    return "";
  } catch (const ProgramError& error) {
    return error.what();
  }
}

TEST(ConditionOptions, DefaultToPerfectConditions) { EXPECT_TRUE(read({}).perfect()); }

struct Case {
  std::string option;
  double LinkQuality::*field;
  double max;
};

const std::vector<Case> kCases = {{"--loss", &LinkQuality::lossPercent, 100},
                                  {"--burst-loss", &LinkQuality::burstLossPercent, 100},
                                  {"--delay", &LinkQuality::delayMs, 10000},
                                  {"--jitter", &LinkQuality::jitterMs, 10000},
                                  {"--duplicate", &LinkQuality::duplicatePercent, 100},
                                  {"--reorder", &LinkQuality::reorderPercent, 100},
                                  {"--rate", &LinkQuality::kilobytesPerSecond, 1000000},
                                  {"--corrupt", &LinkQuality::corruptPercent, 100}};

TEST(ConditionOptions, EachSetsItsFieldOnly) {
  for (const Case& one : kCases) {
    const LinkQuality quality = read({one.option, "12.5"});
    for (const Case& other : kCases) {
      EXPECT_EQ(quality.*other.field, one.option == other.option ? 12.5 : 0) << one.option << " in " << other.option;
    }
    EXPECT_FALSE(quality.perfect()) << one.option;
    EXPECT_TRUE(read({one.option, "0"}).perfect()) << one.option;
  }
}

TEST(ConditionOptions, RefuseValuesOutOfRange) {
  for (const Case& one : kCases) {
    const auto max = std::to_string(static_cast<int>(one.max));
    EXPECT_EQ(refusal({one.option, max}), "") << one.option;
    for (const std::string& value : {std::string("-0.1"), max + ".1", std::string("nan"), std::string("much")}) {
      std::string expected = one.option;
      expected.append(": '")
          .append(value)
          .append("' is not a number from 0 to ")
          .append(max)
          .append(" (see bots --help)");
      EXPECT_EQ(refusal({one.option, value}), expected);
    }
  }
}

TEST(ConditionOptions, BurstLengthNeedsBurstLoss) {
  EXPECT_EQ(read({"--burst-loss", "3"}).burstLength, 4);
  EXPECT_EQ(read({"--burst-length", "7.5", "--burst-loss", "3"}).burstLength, 7.5);
  EXPECT_EQ(refusal({"--burst-loss", "3", "--burst-length", "0.9"}),
            "--burst-length: '0.9' is not a number from 1 to 10000 (see bots --help)");
  EXPECT_EQ(refusal({"--burst-length", "7.5"}), "--burst-length requires --burst-loss (see bots --help)");
}

TEST(ConditionOptions, HaveTheirOwnGroupInTheHelp) {
  ProgramOptions program("bots", "");
  LinkQuality quality;
  addConditionOptions(program, quality);
  const std::string help = program.help();
  const std::size_t group = help.find("Simulated network conditions, each way:");
  ASSERT_NE(group, std::string::npos) << help;
  for (const Case& one : kCases) EXPECT_GT(help.find(one.option + " "), group) << help;
}

}  // namespace
}  // namespace platon::bot_fleet_test
