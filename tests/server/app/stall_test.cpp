// A server that does not run for some time.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "client/bot/bot.h"
#include "tests/net/support/loopback_server.h"

namespace platon::stall_test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

class StallTest : public testing::Test {
 protected:
  std::uint32_t tick() { return server_.server().match().game().tick(); }
  std::vector<std::string> droppedLines() const {
    std::vector<std::string> found;
    std::copy_if(log_.begin(), log_.end(), std::back_inserter(found),
                 [](const std::string& line) { return line.starts_with("ticks dropped"); });
    return found;
  }
  void letPass(Bot& bot, Time duration) {
    server_.runUntil(
        duration, [&bot](Time now) { bot.update(now); }, [] { return false; });
  }

  std::vector<std::string> log_;
  LoopbackServer server_{[this](std::string_view line) { log_.emplace_back(line); }};
};

TEST_F(StallTest, AfterTwoSecondsTheMatchGoesOnWithTheSamePlayers) {
  PlayingBot bot(server_.address(), "bot", ServerKnowledge(), LinkQuality(), 1, server_.clock().now(), Time{});
  letPass(bot, seconds(4));
  ASSERT_TRUE(bot.result().joined);
  const std::uint32_t before = tick();
  server_.suspend(seconds(2), [&bot](Time now) { bot.update(now); });
  letPass(bot, milliseconds(100));
  EXPECT_GE(tick(), before + TickClock::kMaxBehind);
  EXPECT_LE(tick(), before + TickClock::kMaxBehind + 8) << "no more are made up for";
  ASSERT_EQ(droppedLines().size(), 1u);
  EXPECT_NEAR(std::stod(droppedLines()[0].substr(std::string("ticks dropped ticks=").size())), 105, 2);
  const std::uint32_t confirmed = bot.result().prediction.confirmedTicks;
  letPass(bot, seconds(5));
  EXPECT_EQ(bot.result().ending, std::nullopt);
  EXPECT_EQ(bot.result().resumes, 0u);
  EXPECT_EQ(bot.result().round.desyncs, 0u);
  EXPECT_GT(bot.result().prediction.confirmedTicks, confirmed + 290);
}

TEST_F(StallTest, RepeatedStallsAreSaidOnceInTenSeconds) {
  PlayingBot bot(server_.address(), "bot", ServerKnowledge(), LinkQuality(), 1, server_.clock().now(), Time{});
  letPass(bot, seconds(4));
  ASSERT_TRUE(bot.result().joined);
  for (int stall = 0; stall < 8; ++stall) {
    server_.suspend(milliseconds(500), [&bot](Time now) { bot.update(now); });
    letPass(bot, milliseconds(100));
  }
  EXPECT_EQ(droppedLines().size(), 1u);
  letPass(bot, seconds(10));
  EXPECT_EQ(droppedLines().size(), 2u) << "the second line counts all others";
}

// 0.8 s are 48 ticks; 15 of them are made up for.
TEST_F(StallTest, EveryDroppedTickIsCounted) {
  PlayingBot bot(server_.address(), "bot", ServerKnowledge(), LinkQuality(), 1, server_.clock().now(), Time{});
  letPass(bot, seconds(4));
  ASSERT_TRUE(bot.result().joined);
  EXPECT_EQ(server_.server().droppedTicks(), 0u);
  for (const double stalls : {1.0, 2.0, 3.0}) {
    server_.suspend(milliseconds(800), [&bot](Time now) { bot.update(now); });
    letPass(bot, milliseconds(100));
    EXPECT_NEAR(static_cast<double>(server_.server().droppedTicks()), 33 * stalls, stalls);
  }
  EXPECT_EQ(droppedLines().size(), 1u);
}

// The longest tick of the last play was told for as long as the server ran.
TEST_F(StallTest, TheTickTimesOfAServerThatIsEmptyEndAfterTwoMinutes) {
  server_.server().setClock([this] { return TimePoint(server_.clock().now()); });
  {
    PlayingBot bot(server_.address(), "bot", ServerKnowledge(), LinkQuality(), 1, server_.clock().now(), Time{});
    letPass(bot, seconds(4));
    ASSERT_TRUE(bot.result().joined);
  }
  const auto pass = [this](Time duration) {
    server_.runUntil(
        duration, [](Time) {}, [] { return false; });
  };
  pass(seconds(30));
  EXPECT_GT(server_.server().recentTickTimes().longest(), 0u);
  pass(seconds(60 + 120));  // the bot can resume for a minute
  EXPECT_GT(server_.server().tickTimes().count(), 0u);
  const TickTimes recent = server_.server().recentTickTimes();
  EXPECT_EQ(recent.longest(), 0u);
  EXPECT_EQ(recent.quantile(0.99), 0u);
  EXPECT_EQ(recent.quantile(0.5), 0u);
}

TEST_F(StallTest, AServerWithoutPlayersDropsNothing) {
  server_.suspend(seconds(60), [](Time) {});
  server_.runUntil(
      seconds(1), [](Time) {}, [] { return false; });
  EXPECT_TRUE(droppedLines().empty());
  EXPECT_EQ(server_.server().droppedTicks(), 0u);
}

}  // namespace
}  // namespace platon::stall_test
