// When a round ends although not all players have finished.
#include <gtest/gtest.h>

#include "server/match/match.h"
#include "tests/net/support/fake_client.h"
#include "tests/net/support/fake_client_network.h"
#include "tests/support/test_levels.h"

namespace platon::match_round_end_test {
namespace {

using Kind = MatchEvent::Kind;

constexpr std::uint32_t kActiveTicks = MatchPlayer::kActiveTicks;

int idle(std::uint32_t) { return 0; }
int running(std::uint32_t) { return Input::kRight; }

// A floor on which a player that runs to the right reaches the goal within two seconds.
std::string shortWayText() {
  return "HEXAHEDRON\n0 -100 -180 0\n0 0 -190\n480\n%\n-240 -200 240 -200\n-120 -200 -120 0\n%\n%\n%\n%\n%\n";
}

class MatchRoundEnd : public testing::Test {
 protected:
  explicit MatchRoundEnd(const std::string& head = "")
      : network_(Match(LevelRotation({levelOf(head + shortWayText())}), {4, "Test"}), {.delayMs = kTickMs}) {}

  FakeClient& add(std::function<int(std::uint32_t)> buttons) {
    return network_.add(FakeClient("P", 12, std::move(buttons)));
  }
  bool ended() { return network_.count(Kind::kRoundEnd) == 1; }
  bool finished(std::uint32_t slot) { return network_.match().game().player(slot).finished(); }

  // Ticks until the round ends; at most `limit`.
  std::uint32_t ticksUntilEnd(std::uint32_t limit) {
    std::uint32_t ticks = 0;
    for (; ticks < limit && !ended(); ++ticks) network_.tick();
    return ticks;
  }

  FakeClientNetwork network_;
};

class MatchRoundEndForTwo : public MatchRoundEnd {
 protected:
  MatchRoundEndForTwo() : MatchRoundEnd("# players: 2\n") {}
};

TEST_F(MatchRoundEnd, APlayerThatChangesNoButtonForAMinuteDoesNotHoldTheRound) {
  add(running);
  add(idle);
  network_.run(200);
  ASSERT_TRUE(finished(0));
  EXPECT_FALSE(finished(1));
  const std::uint32_t ticks = ticksUntilEnd(2 * kActiveTicks);
  EXPECT_EQ(200 + ticks, kActiveTicks + 1) << "a player is active when it joins";
  EXPECT_FALSE(network_.match().game().over()) << "the game itself waits";
  const std::uint32_t end = network_.match().game().tick();
  network_.run(2);
  ASSERT_TRUE(network_.client(1).roundEnd());
  EXPECT_EQ(network_.client(1).roundEnd()->tick, end);
}

TEST_F(MatchRoundEnd, AButtonThatIsHeldIsNoChange) {
  add(running);
  add([](std::uint32_t) { return Input::kLeft; });
  EXPECT_LE(ticksUntilEnd(2 * kActiveTicks), kActiveTicks + 60);
  EXPECT_TRUE(ended());
}

TEST_F(MatchRoundEnd, APlayerCountsAgainWithItsNextButton) {
  add(running);
  add([](std::uint32_t tick) { return tick < kActiveTicks - 200 ? 0 : +Input::kLeft; });
  const std::uint32_t ticks = ticksUntilEnd(3 * kActiveTicks);
  EXPECT_GE(ticks, 2 * kActiveTicks - 220);
  EXPECT_LE(ticks, 2 * kActiveTicks - 180);
}

TEST_F(MatchRoundEnd, TheRoundGoesOnWhileNobodyHasFinished) {
  add(idle);
  add(idle);
  network_.run(kActiveTicks + 600);
  EXPECT_FALSE(ended());
}

TEST_F(MatchRoundEnd, AnInactivePlayerStaysInactiveInTheNextRound) {
  add(running);
  add(idle);
  ticksUntilEnd(2 * kActiveTicks);
  network_.run(MatchRounds::kPauseTicks + 150);
  EXPECT_EQ(network_.match().round(), 2u);
  EXPECT_EQ(network_.count(Kind::kRoundEnd), 2u) << "it ended when the first player finished";
}

TEST_F(MatchRoundEnd, ARoundWaitsTenSecondsForADisconnectedPlayer) {
  add(running);
  add(idle);
  network_.run(200);
  ASSERT_TRUE(finished(0));
  network_.disconnect(2);
  const std::uint32_t ticks = ticksUntilEnd(kActiveTicks);
  EXPECT_EQ(ticks, MatchRounds::kAwaitTicks);
  EXPECT_FALSE(network_.match().idle());
}

TEST_F(MatchRoundEnd, ADisconnectedPlayerThatIsResumedInTimeHoldsTheRound) {
  add(running);
  add(idle);
  network_.run(200);
  network_.disconnect(2);
  network_.run(MatchRounds::kAwaitTicks - 60);
  network_.add(FakeClient(network_.client(2), idle));
  network_.run(300);
  EXPECT_FALSE(ended());
  network_.disconnect(1);
  EXPECT_LT(ticksUntilEnd(kActiveTicks), kActiveTicks);
}

// Who stands on a plate for another one presses nothing.
TEST_F(MatchRoundEndForTwo, WhoPressesNothingHasAMinuteAfterTheFirstFinish) {
  add([](std::uint32_t tick) { return tick > 2 * kActiveTicks ? +Input::kRight : tick / 8 % 2; });
  add(idle);
  network_.run(2 * kActiveTicks);
  std::uint32_t waited = 0;
  for (; !finished(0) && waited < 600; ++waited) network_.tick();
  ASSERT_TRUE(finished(0));
  EXPECT_FALSE(ended());
  EXPECT_EQ(ticksUntilEnd(2 * kActiveTicks), kActiveTicks);
}

TEST_F(MatchRoundEnd, TheNextRoundStartsFiveSecondsAfterTheEnd) {
  add(running);
  add(idle);
  ticksUntilEnd(2 * kActiveTicks);
  network_.run(MatchRounds::kPauseTicks - 1);
  EXPECT_EQ(network_.match().round(), 1u);
  network_.run(1);
  EXPECT_EQ(network_.match().round(), 2u);
}

}  // namespace
}  // namespace platon::match_round_end_test
