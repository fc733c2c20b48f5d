#include "client/netcode/interpolation_buffer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tests/support/test_levels.h"

namespace platon::interpolation_buffer_test {
namespace {

using std::chrono::milliseconds;

constexpr Time kStart = std::chrono::seconds(50);
constexpr double kPerfectDelay = 1 + InterpolationBuffer::kSpareTicks;

// A game with one running player, whose ticks arrive at given times.
class InterpolationBufferTest : public testing::Test {
 protected:
  InterpolationBufferTest() { buffer_.restart(game_, 0); }

  // `count` ticks arrive now.
  void receive(int count) {
    for (int i = 0; i < count; ++i) {
      game_.advance(running_);
      xs_.push_back(game_.world().entities()[0].position.x);
      buffer_.advanced(game_);
    }
    buffer_.arrived(now());
  }

  // Lets so many ticks of real time pass.
  void pass(double ticks) {
    time_ += ticks;
    const double before = buffer_.tick();
    const std::uint32_t jumps = buffer_.jumps();
    buffer_.update(now());
    ASSERT_LE(buffer_.tick(), buffer_.newest());
    if (buffer_.jumps() != jumps) return;
    ASSERT_GE(buffer_.tick(), before);
    ASSERT_LE(buffer_.tick() - before, ticks * (1 + InterpolationBuffer::kMaxSlew) + 1e-3);
  }

  // Lets `ticks` ticks arrive, one per tick of time, except that of every `of` ticks the first `late` ones arrive late,
  // together with the next one.
  void play(int ticks, int of = 1, int late = 0) {
    for (int i = 0; i < ticks; ++i) {
      pass(1);
      const int phase = i % of;
      if (phase < of - late) receive(phase == 0 ? late + 1 : 1);
    }
  }

  Time now() const { return kStart + Time(std::llround(time_ * 1e6 / kTicksPerSecond)); }

  // Checks positions and fraction against the recorded positions of the runner.
  void checkPlayers() const {
    const InterpolatedPlayers players = buffer_.players();
    const auto before = static_cast<std::size_t>(buffer_.tick());
    ASSERT_LT(before, xs_.size());
    EXPECT_EQ(players.at(0).before.position.x, xs_[before - 1]);
    EXPECT_EQ(players.at(0).now.position.x, xs_[before]);
    EXPECT_NEAR(players.fraction, buffer_.tick() - static_cast<double>(before), 1e-9);
  }

  Game game_{endlessLevel()};
  const std::vector<Input> running_ = {Input{Input::kPresent | Input::kRight}};
  InterpolationBuffer buffer_;
  std::vector<std::int32_t> xs_;  // x after each tick, from tick 1 on
  double time_ = 0;
};

TEST_F(InterpolationBufferTest, ShowsASingleTick) {
  EXPECT_EQ(buffer_.tick(), 0);
  EXPECT_TRUE(buffer_.players().now.empty());
  Game game(endlessLevel());
  for (int i = 0; i < 9; ++i) game.advance(running_);
  buffer_.restart(game, 9);
  EXPECT_EQ(buffer_.tick(), 9);
  const InterpolatedPlayers players = buffer_.players();
  ASSERT_EQ(players.before.size(), 1u);
  ASSERT_EQ(players.now.size(), 1u);
  EXPECT_EQ(players.before[0].position, game.world().entities()[0].position);
  EXPECT_TRUE(players.now[0].present);
  EXPECT_EQ(buffer_.jumps(), 0u);  // the clock had not started
}

TEST_F(InterpolationBufferTest, IsOneAndAHalfTicksBehindOnAPerfectConnection) {
  play(300);
  EXPECT_NEAR(buffer_.targetDelay(), kPerfectDelay, 1e-3);
  EXPECT_NEAR(buffer_.newest() - buffer_.tick(), kPerfectDelay, 1e-3);
  EXPECT_EQ(buffer_.jumps(), 0u);
}

TEST_F(InterpolationBufferTest, InterpolatesBetweenTwoTicks) {
  play(60);
  for (int i = 0; i < 20; ++i) {
    pass(0.3);
    checkPlayers();
    if (i % 3 == 2) receive(1);
  }
}

TEST_F(InterpolationBufferTest, DelayCoversTheLatenessOf99PerCent) {
  play(2000, 10, 4);  // four of ten arrive late, by at most four ticks
  EXPECT_NEAR(buffer_.targetDelay(), 4 + kPerfectDelay, 1e-2);
  EXPECT_NEAR(buffer_.error(), 0, 1e-2);
  play(2000, 500, 4);  // less than one in a hundred
  EXPECT_NEAR(buffer_.targetDelay(), kPerfectDelay, 1e-2);
}

TEST_F(InterpolationBufferTest, NeverStopsUnderConstantJitter) {
  play(1001, 7, 5);
  for (int i = 0; i < 100; ++i) {
    const double before = buffer_.tick();
    play(7, 7, 5);
    EXPECT_NEAR(buffer_.tick() - before, 7, 0.1);
  }
}

TEST_F(InterpolationBufferTest, StopsAtTheNewestTickAndCatchesUpBySlewing) {
  play(600);
  pass(6);  // five ticks are late: less than one in a hundred
  EXPECT_EQ(buffer_.tick(), buffer_.newest());
  EXPECT_EQ(buffer_.players().fraction, 1);
  EXPECT_EQ(buffer_.players().at(0).now.position.x, xs_.back());
  receive(6);
  const double missing = 6 - kPerfectDelay;
  EXPECT_NEAR(buffer_.error(), -missing, 1e-2);
  const int needed = static_cast<int>(missing / InterpolationBuffer::kMaxSlew);
  play(needed - 2);
  EXPECT_LT(buffer_.error(), -InterpolationBuffer::kMaxSlew);
  play(4);
  EXPECT_NEAR(buffer_.error(), 0, 1e-3);
  EXPECT_NEAR(buffer_.newest() - buffer_.tick(), kPerfectDelay, 1e-2);
  EXPECT_EQ(buffer_.jumps(), 0u);
}

TEST_F(InterpolationBufferTest, JumpsOverAStallAndDoesNotMeasureIt) {
  play(300);
  const double before = buffer_.tick();
  pass(120);
  EXPECT_LE(buffer_.tick(), before + kPerfectDelay + 1e-3);
  receive(120);
  EXPECT_EQ(buffer_.jumps(), 1u);
  EXPECT_NEAR(buffer_.newest() - buffer_.tick(), kPerfectDelay, 1e-2);
  EXPECT_NEAR(buffer_.targetDelay(), kPerfectDelay, 1e-2);
}

TEST_F(InterpolationBufferTest, NeverFallsBehindTheOldestTick) {
  play(300);
  for (int i = 0; i < 200; ++i) {  // the server runs at half speed, then catches up at once
    pass(2);
    receive(1);
  }
  for (int i = 0; i < 8; ++i) receive(25);
  checkPlayers();  // before the next update
  pass(1);
  checkPlayers();
  EXPECT_LE(buffer_.targetDelay(), InterpolationBuffer::kMaxDelay);
  EXPECT_LE(buffer_.newest() - buffer_.tick(), InterpolationBuffer::kMaxDelay + InterpolationBuffer::kJumpTicks + 1);
}

TEST_F(InterpolationBufferTest, RestartDiscardsAllTicks) {
  play(1001, 7, 5);
  Game other(endlessLevel());
  for (int i = 0; i < 50; ++i) other.advance(std::vector<Input>(3, running_[0]));
  const std::uint32_t start = buffer_.newest();
  buffer_.restart(other, start);
  EXPECT_EQ(buffer_.tick(), start);
  EXPECT_EQ(buffer_.jumps(), 1u);
  EXPECT_EQ(buffer_.players().before.size(), 3u);
  pass(1);
  buffer_.advanced(other);
  buffer_.arrived(now());
  EXPECT_EQ(buffer_.tick(), start);  // the oldest tick
  pass(1);
  EXPECT_NEAR(buffer_.tick(), start + 1 - InterpolationBuffer::kMaxSlew, 1e-3);
  EXPECT_EQ(buffer_.jumps(), 1u);
}

TEST_F(InterpolationBufferTest, TicksThatARestartHeldBackAreNotMeasured) {
  receive(20);
  play(100);
  EXPECT_NEAR(buffer_.targetDelay(), kPerfectDelay, 1e-2);
  EXPECT_EQ(buffer_.jumps(), 0u);
}

TEST_F(InterpolationBufferTest, ArrivedWithoutNewTicksMeasuresNothing) {
  play(100);
  const double delay = buffer_.targetDelay();
  for (int i = 0; i < 600; ++i) buffer_.arrived(now() + std::chrono::seconds(1));
  EXPECT_EQ(buffer_.targetDelay(), delay);
}

// The tick of a full state comes from the server, so it may have any value.
TEST_F(InterpolationBufferTest, AcceptsTicksUpToTheLargest) {
  buffer_.restart(game_, UINT32_MAX);
  const InterpolatedPlayers alone = buffer_.players();
  EXPECT_EQ(alone.now.size(), game_.slots());
  EXPECT_EQ(alone.fraction, 0);
  buffer_.restart(game_, UINT32_MAX - 1);
  receive(1);
  EXPECT_EQ(buffer_.newest(), UINT32_MAX);
  const InterpolatedPlayers last = buffer_.players();
  EXPECT_EQ(last.now.size(), 1u);
  EXPECT_GE(last.fraction, 0);
  EXPECT_LE(last.fraction, 1);
}

}  // namespace
}  // namespace platon::interpolation_buffer_test
