#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "client/bot/bot.h"
#include "client/play/match_play.h"
#include "client/time/steady_now.h"
#include "server/app/dedicated_server.h"
#include "tests/support/test_level.h"

namespace platon {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr const char* kLoopback = "127.0.0.1";

/// A server that steps whenever its clients sleep: on real sockets, in one thread and in a time of its own.
class BadLine : public testing::Test {
 protected:
  ServerAddress address() const { return {kLoopback, server_.port()}; }
  DedicatedServer& server() { return server_; }
  const Clock& clock() const { return clock_; }

 private:
  static ServerSettings settings() {
    ServerSettings settings;
    settings.host.bind = kLoopback;
    return settings;
  }

  DedicatedServer server_{settings(), {endlessLevel()}, Log(LogFormat::kText, [](std::string_view) {})};
  Moment now_ = steadyClock().now();
  Clock clock_{[this] { return now_; },
               [this](Moment until) {
                 server_.step(TimePoint(now_));
                 now_ = until;
               }};
};

class BadLineToBots : public BadLine {
 protected:
  static constexpr std::uint64_t kTicks = 120;

  // Three bots play until each has got so many ticks, or has fallen out, or twenty seconds have passed.
  void play(const LinkQuality& line) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      bots_.push_back(std::make_unique<PlayingBot>(address(), "bot", line, seed, clock().now(), Moment{}));
    }
    const Moment end = clock().now() + seconds(20);
    for (Moment now = clock().now(); now < end && !done(); now = clock().now()) {
      for (const auto& bot : bots_) bot->update(now);
      clock().sleepUntil(now + milliseconds(2));
    }
  }

  void expectInStep() {
    for (const auto& bot : bots_) {
      const BotResult result = bot->result();
      EXPECT_EQ(result.ending, std::nullopt);
      EXPECT_GE(result.prediction.confirmedTicks, kTicks);
      EXPECT_EQ(result.round.desyncs, 0u);
      EXPECT_EQ(result.round.resyncs, 0u);
    }
    EXPECT_EQ(server().brokenMessages(), 0u);
  }

 private:
  bool done() const {
    return std::all_of(bots_.begin(), bots_.end(), [](const auto& bot) {
      return bot->closed() || bot->result().prediction.confirmedTicks >= kTicks;
    });
  }

  std::vector<std::unique_ptr<Bot>> bots_;
};

// What the checksum let pass would be a broken message, or one that lies.
TEST_F(BadLineToBots, FlippedBitsAreOnlyLosses) {
  LinkQuality line;
  line.corruptPercent = 5;
  play(line);
  expectInStep();
}

TEST_F(BadLineToBots, BurstsOnANarrowLineAreOnlyLosses) {
  LinkQuality line;
  line.burstLossPercent = 5;
  line.burstLength = 5;
  line.kilobytesPerSecond = 8;
  play(line);
  expectInStep();
}

/// What playing with and without a window has in common, on a line.
class BadLineToThePlayer : public BadLine {
 protected:
  // Updates until `done` or `patience` has passed; whether it is done.
  template <class Done>
  bool updateUntil(MatchPlay& play, Moment patience, Done done) {
    const Moment end = clock().now() + patience;
    for (Moment now = clock().now(); now < end; now = clock().now()) {
      play.update(now, [](const Game&, std::uint32_t) { return Input{Input::kRight}; });
      if (done()) return true;
      clock().sleepUntil(now + milliseconds(2));
    }
    return false;
  }
};

TEST_F(BadLineToThePlayer, HasItsDelayAndCanBeLeft) {
  ClientOptions options;
  options.line.delayMs = 60;
  const Moment begun = clock().now();
  MatchPlay play(options, address(), begun);
  EXPECT_EQ(play.message(), "connecting to " + address().text() + " …");  // not to the relay
  ASSERT_TRUE(updateUntil(play, seconds(10), [&] {
    return play.client().session() != nullptr && play.client().session()->predictionStatistics().confirmedTicks > 30;
  })) << play.message();
  EXPECT_GE(play.client().session()->reading().rttMs, 120);
  ASSERT_EQ(server().match().players(), 1u);
  play.leave(clock());
  EXPECT_TRUE(play.client().closed());
  EXPECT_EQ(server().match().players(), 0u);
}

TEST_F(BadLineToThePlayer, LosesEverythingWhenItIsDead) {
  ClientOptions options;
  options.line.lossPercent = 100;
  MatchPlay play(options, address(), clock().now());
  EXPECT_FALSE(updateUntil(play, seconds(1), [&] { return play.client().session() != nullptr; }));
  EXPECT_EQ(server().match().players(), 0u);
}

TEST_F(BadLineToThePlayer, DoesNotHideThatTheHostIsNotKnown) {
  ClientOptions options;
  options.line.delayMs = 60;
  try {
    MatchPlay({options}, {"no such host", 1}, clock().now());
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()), "the host no such host is not known");
  }
}

}  // namespace
}  // namespace platon
