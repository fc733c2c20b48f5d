#include "client/netcode/interpolation_buffer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tests/support/test_level.h"

namespace platon {
namespace {

using std::chrono::milliseconds;

constexpr Moment kStart = std::chrono::seconds(50);
constexpr double kPerfectDelay = 1 + InterpolationBuffer::kSpareTicks;

// A game in which somebody runs, looked at from the end of a line that is told how late its ticks come.
class ConfirmedViewTest : public testing::Test {
 protected:
  ConfirmedViewTest() { view_.restart(game_, 0); }

  // `count` ticks come now.
  void receive(int count) {
    for (int i = 0; i < count; ++i) {
      game_.advance(running_);
      xs_.push_back(game_.world().entities()[0].position.x);
      view_.advanced(game_);
    }
    view_.arrived(now());
  }

  // Real time, ticks of it.
  void pass(double ticks) {
    time_ += ticks;
    const double before = view_.tick();
    const std::uint32_t jumps = view_.jumps();
    view_.update(now());
    ASSERT_LE(view_.tick(), view_.newest());
    if (view_.jumps() != jumps) return;
    ASSERT_GE(view_.tick(), before);
    ASSERT_LE(view_.tick() - before, ticks * (1 + InterpolationBuffer::kMaxSlew) + 1e-3);
  }

  // Ticks that come each as late as it may, the `count` first of `of` by `late` ticks.
  void play(int ticks, int of = 1, int late = 0) {
    for (int i = 0; i < ticks; ++i) {
      pass(1);
      const int phase = i % of;
      if (phase < of - late) receive(phase == 0 ? late + 1 : 1);
    }
  }

  Moment now() const { return kStart + Moment(std::llround(time_ * 1e6 / kTicksPerSecond)); }

  // What is drawn is what the runner was at both ticks, and as far between as the view is.
  void checkPlayers() const {
    const InterpolatedPlayers players = view_.players();
    const auto before = static_cast<std::size_t>(view_.tick());
    ASSERT_LT(before, xs_.size());
    EXPECT_EQ(players.at(0).before.position.x, xs_[before - 1]);
    EXPECT_EQ(players.at(0).now.position.x, xs_[before]);
    EXPECT_NEAR(players.fraction, view_.tick() - static_cast<double>(before), 1e-9);
  }

  Game game_{endlessLevel()};
  const std::vector<Input> running_ = {Input{Input::kPresent | Input::kRight}};
  InterpolationBuffer view_;
  std::vector<std::int32_t> xs_;  // after every tick, from the first on
  double time_ = 0;
};

TEST_F(ConfirmedViewTest, ShowsTheOnlyTickThereIs) {
  EXPECT_EQ(view_.tick(), 0);
  EXPECT_TRUE(view_.players().now.empty());
  Game game(endlessLevel());
  for (int i = 0; i < 9; ++i) game.advance(running_);
  view_.restart(game, 9);
  EXPECT_EQ(view_.tick(), 9);
  const InterpolatedPlayers players = view_.players();
  ASSERT_EQ(players.before.size(), 1u);
  ASSERT_EQ(players.now.size(), 1u);
  EXPECT_EQ(players.before[0].position, game.world().entities()[0].position);
  EXPECT_TRUE(players.now[0].present);
  EXPECT_EQ(view_.jumps(), 0u);  // it had not begun
}

TEST_F(ConfirmedViewTest, OnAnEvenLineItIsATickAndAHalfBehind) {
  play(300);
  EXPECT_NEAR(view_.targetDelay(), kPerfectDelay, 1e-3);
  EXPECT_NEAR(view_.newest() - view_.tick(), kPerfectDelay, 1e-3);
  EXPECT_EQ(view_.jumps(), 0u);
}

TEST_F(ConfirmedViewTest, ShowsThePlaceBetweenTheTwoTicks) {
  play(60);
  for (int i = 0; i < 20; ++i) {
    pass(0.3);
    checkPlayers();
    if (i % 3 == 2) receive(1);
  }
}

TEST_F(ConfirmedViewTest, OneInAHundredMayComeLater) {
  play(2000, 10, 4);  // four of ten come late, the first of them by four ticks
  EXPECT_NEAR(view_.targetDelay(), 4 + kPerfectDelay, 1e-2);
  EXPECT_NEAR(view_.error(), 0, 1e-2);
  play(2000, 500, 4);  // less than one in a hundred
  EXPECT_NEAR(view_.targetDelay(), kPerfectDelay, 1e-2);
}

TEST_F(ConfirmedViewTest, NeverRunsOutOnALineThatIsAsBadAsEver) {
  play(1001, 7, 5);
  for (int i = 0; i < 100; ++i) {
    const double before = view_.tick();
    play(7, 7, 5);
    EXPECT_NEAR(view_.tick() - before, 7, 0.1);
  }
}

TEST_F(ConfirmedViewTest, WaitsForTheNewestAndCatchesUpBySlewing) {
  play(600);
  pass(6);  // five ticks are late: less than one in a hundred
  EXPECT_EQ(view_.tick(), view_.newest());
  receive(6);
  const double missing = 6 - kPerfectDelay;
  EXPECT_NEAR(view_.error(), -missing, 1e-2);
  const int needed = static_cast<int>(missing / InterpolationBuffer::kMaxSlew);
  play(needed - 2);
  EXPECT_LT(view_.error(), -InterpolationBuffer::kMaxSlew);
  play(4);
  EXPECT_NEAR(view_.error(), 0, 1e-3);
  EXPECT_NEAR(view_.newest() - view_.tick(), kPerfectDelay, 1e-2);
  EXPECT_EQ(view_.jumps(), 0u);
}

TEST_F(ConfirmedViewTest, AStallIsPassedOverByAJumpAndIsNoJitter) {
  play(300);
  const double before = view_.tick();
  pass(120);
  EXPECT_LE(view_.tick(), before + kPerfectDelay + 1e-3);
  receive(120);
  EXPECT_EQ(view_.jumps(), 1u);
  EXPECT_NEAR(view_.newest() - view_.tick(), kPerfectDelay, 1e-2);
  EXPECT_NEAR(view_.targetDelay(), kPerfectDelay, 1e-2);
}

TEST_F(ConfirmedViewTest, IsNeverFartherBehindThanIsKept) {
  play(300);
  for (int i = 0; i < 200; ++i) {  // the server at half speed, then all the rest at once
    pass(2);
    receive(1);
  }
  for (int i = 0; i < 8; ++i) receive(25);
  checkPlayers();  // although no time has passed since
  pass(1);
  checkPlayers();
  EXPECT_LE(view_.targetDelay(), InterpolationBuffer::kMaxDelay);
  EXPECT_LE(view_.newest() - view_.tick(), InterpolationBuffer::kMaxDelay + InterpolationBuffer::kJumpTicks + 1);
}

TEST_F(ConfirmedViewTest, AFullStateStartsItAnew) {
  play(1001, 7, 5);
  Game other(endlessLevel());
  for (int i = 0; i < 50; ++i) other.advance(std::vector<Input>(3, running_[0]));
  const std::uint32_t start = view_.newest();
  view_.restart(other, start);
  EXPECT_EQ(view_.tick(), start);
  EXPECT_EQ(view_.jumps(), 1u);
  EXPECT_EQ(view_.players().before.size(), 3u);
  pass(1);
  view_.advanced(other);
  view_.arrived(now());
  EXPECT_EQ(view_.tick(), start);  // nothing older is known
  pass(1);
  EXPECT_NEAR(view_.tick(), start + 1 - InterpolationBuffer::kMaxSlew, 1e-3);
  EXPECT_EQ(view_.jumps(), 1u);
}

TEST_F(ConfirmedViewTest, NothingNewMeasuresNothing) {
  play(100);
  const double delay = view_.targetDelay();
  for (int i = 0; i < 600; ++i) view_.arrived(now() + std::chrono::seconds(1));
  EXPECT_EQ(view_.targetDelay(), delay);
}

}  // namespace
}  // namespace platon
