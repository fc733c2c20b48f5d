#include "client/bot/hollow_bot.h"

#include <gtest/gtest.h>

#include <optional>

#include "tests/support/loopback_server.h"

namespace platon::hollow_bot_test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

class HollowBotTest : public testing::Test {
 protected:
  HollowBot join(const LinkQuality& quality) {
    return HollowBot(server_.address(), "hollow", {}, quality, 1, server_.clock().now(), Moment{});
  }
  bool playUntil(HollowBot& bot, std::uint32_t ticks) {
    return server_.runUntil(
        seconds(20), [&](Moment now) { bot.update(now); },
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
  EXPECT_EQ(server_.server().malformedMessages(), 0u);
}

TEST_F(HollowBotTest, LeaveRemovesThePlayer) {
  HollowBot bot = join(LinkQuality());
  ASSERT_TRUE(playUntil(bot, 10));
  bot.leave();
  EXPECT_TRUE(server_.runUntil(
      seconds(2), [&](Moment now) { bot.update(now); }, [&] { return bot.closed(); }));
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
}  // namespace platon::hollow_bot_test
