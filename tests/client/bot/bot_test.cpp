#include "client/bot/bot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "tests/net/support/loopback_server.h"

namespace platon::bot_test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

class PlayingBots : public testing::Test {
 protected:
  static constexpr std::uint32_t kTicks = 120;

  // Three bots play until each has confirmed kTicks.
  void play(const LinkQuality& quality) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      bots_.push_back(std::make_unique<PlayingBot>(server_.address(), "bot", ServerKnowledge(), quality, seed,
                                                   server_.clock().now(), Time{}));
    }
    EXPECT_TRUE(
        runUntilAll([](const Bot& bot) { return bot.closed() || bot.result().prediction.confirmedTicks >= kTicks; }));
  }

  void update(Time now) {
    for (const auto& bot : bots_) bot->update(now);
  }

  template <class Condition>
  bool runUntilAll(Condition condition) {
    const auto done = [&] {
      return std::all_of(bots_.begin(), bots_.end(), [&](const auto& bot) { return condition(*bot); });
    };
    return server_.runUntil(
        seconds(20), [this](Time now) { update(now); }, done);
  }

  void expectLockstep() {
    ASSERT_EQ(bots_.size(), 3u);
    for (const auto& bot : bots_) {
      const BotResult result = bot->result();
      EXPECT_EQ(result.ending, std::nullopt);
      EXPECT_GE(result.prediction.confirmedTicks, kTicks);
      EXPECT_EQ(result.round.desyncs, 0u);
      EXPECT_EQ(result.round.resyncs, 0u);
    }
    EXPECT_EQ(server_.server().host().rejections().message, 0u);
  }

  LoopbackServer server_;
  std::vector<std::unique_ptr<Bot>> bots_;
};

// The checksum must detect all flipped bits: an undetected one would be a malformed or wrong message.
TEST_F(PlayingBots, StayInLockstepWithCorruptedDatagrams) {
  LinkQuality quality;
  quality.corruptPercent = 5;
  play(quality);
  expectLockstep();
}

TEST_F(PlayingBots, StayInLockstepWithBurstLossAndLowBandwidth) {
  LinkQuality quality;
  quality.burstLossPercent = 5;
  quality.burstLength = 5;
  quality.kilobytesPerSecond = 8;
  play(quality);
  expectLockstep();
}

TEST_F(PlayingBots, CountTheirResumes) {
  play(LinkQuality());
  server_.suspend(Session::kTimeout + seconds(1), [this](Time now) { update(now); });
  EXPECT_TRUE(runUntilAll([](const Bot& bot) { return bot.result().resumes == 1; }));
  expectLockstep();
}

TEST_F(PlayingBots, ReportAnUnreachableServer) {
  PlayingBot bot({"127.0.0.1", 1}, "bot", {}, LinkQuality(), 1, Time{}, Time{});
  for (Time now{}; now <= seconds(6); now += std::chrono::milliseconds(50)) bot.update(now);
  EXPECT_TRUE(bot.closed());
  EXPECT_FALSE(bot.result().joined);
  EXPECT_EQ(bot.result().ending, "no answer from 127.0.0.1:1 within 5 s: is platon-server running there?");
}

class HollowBotTest : public testing::Test {
 protected:
  HollowBot join(const LinkQuality& quality) {
    return HollowBot(server_.address(), "hollow", {}, quality, 1, server_.clock().now(), Time{});
  }
  bool playUntil(HollowBot& bot, std::uint32_t ticks) {
    return server_.runUntil(
        seconds(20), [&](Time now) { bot.update(now); },
        [&] { return bot.closed() || bot.result().prediction.confirmedTicks >= ticks; });
  }

  LoopbackServer server_;
};

TEST_F(HollowBotTest, PlaysUnderSimulatedNetworkConditions) {
  LinkQuality quality;
  quality.delayMs = 40;
  HollowBot bot = join(quality);
  ASSERT_TRUE(playUntil(bot, 120));
  const BotResult result = bot.result();
  EXPECT_EQ(result.ending, std::nullopt);
  EXPECT_TRUE(result.joined);
  EXPECT_GE(result.link.rttMs, 80);
  EXPECT_GE(result.connectMs, 160);  // connection and Hello
  EXPECT_GT(result.traffic.sentBytes, 0u);
  EXPECT_EQ(server_.server().match().players(), 1u);
  EXPECT_EQ(server_.server().host().rejections().message, 0u);
}

TEST_F(HollowBotTest, LeaveRemovesThePlayer) {
  HollowBot bot = join(LinkQuality());
  ASSERT_TRUE(playUntil(bot, 10));
  bot.leave();
  EXPECT_TRUE(server_.runUntil(
      seconds(2), [&](Time now) { bot.update(now); }, [&] { return bot.closed(); }));
  EXPECT_EQ(server_.server().match().players(), 0u);
}

TEST_F(HollowBotTest, ReportsWhyTheServerEndedTheGame) {
  HollowBot bot = join(LinkQuality());
  ASSERT_TRUE(playUntil(bot, 10));
  server_.server().stop("maintenance");
  for (int i = 0; i < 100 && !bot.closed(); ++i) bot.update(server_.clock().now() + milliseconds(i));
  EXPECT_EQ(bot.result().ending, "the server ended the game: maintenance");
}

}  // namespace
}  // namespace platon::bot_test
