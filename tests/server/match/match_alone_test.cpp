// A match that waits for a player who is alone.
#include <gtest/gtest.h>

#include "protocol/limits.h"
#include "server/match/match.h"
#include "tests/net/support/fake_client.h"
#include "tests/net/support/fake_client_network.h"
#include "tests/server/match/kept_times.h"
#include "tests/support/test_levels.h"

namespace platon::match_alone_test {
namespace {

int idle(std::uint32_t) { return 0; }
int running(std::uint32_t) { return Input::kRight; }

// A floor on which a player that runs to the right reaches the goal within two seconds.
std::string shortWayText() {
  return "HEXAHEDRON\n0 -100 -180 0\n0 0 -190\n480\n%\n-240 -200 240 -200\n-120 -200 -120 0\n%\n%\n%\n%\n%\n";
}

class MatchAlone : public testing::Test {
 protected:
  MatchAlone()
      : network_(Match(LevelRotation({levelOf(shortWayText())}),
                       {.maxPlayers = 4, .serverName = "Test", .waitsForOne = true}, {.bestTimes = &times_}),
                 {.delayMs = kTickMs}) {}

  FakeClient& add(std::function<int(std::uint32_t)> buttons) {
    return network_.add(FakeClient("P", 12, std::move(buttons)));
  }
  std::size_t ends() { return network_.count(MatchEvent::Kind::kRoundEnd); }

  KeptTimes times_;
  FakeClientNetwork network_;
};

TEST_F(MatchAlone, ARoundHasNoTimeLimit) {
  add(idle);
  network_.run(kRoundTicks + 600);
  EXPECT_TRUE(network_.match().game().over()) << "its own clock has run out";
  EXPECT_EQ(ends(), 0U);
  EXPECT_EQ(network_.match().round(), 1U);
}

TEST_F(MatchAlone, WhoReachesTheGoalAfterTheTimeEndsTheRoundAndIsTimed) {
  add([](std::uint32_t tick) { return tick < kRoundTicks + 600 ? +Input::kLeft : +Input::kRight; });
  network_.run(kRoundTicks + 900);
  EXPECT_EQ(ends(), 1U);
  ASSERT_EQ(times_.offered.size(), 1U);
  EXPECT_GT(times_.offered[0].ticks, kRoundTicks);
}

TEST_F(MatchAlone, TheNextRoundStartsWhenItIsAskedFor) {
  add(running);
  network_.run(20 * MatchRounds::kPauseTicks);
  EXPECT_EQ(ends(), 1U);
  ASSERT_TRUE(network_.client(1).roundEnd());
  EXPECT_EQ(network_.client(1).roundEnd()->pauseTicks, 0U);
  EXPECT_EQ(network_.match().round(), 1U);
  network_.match().startNextRound();
  EXPECT_EQ(network_.match().round(), 2U);
}

TEST_F(MatchAlone, WithASecondPlayerTheTimeCountsAgain) {
  add(idle);
  network_.run(kRoundTicks + 600);
  add(idle);
  network_.run(5);
  EXPECT_EQ(ends(), 1U) << "the time has passed";
  network_.run(MatchRounds::kPauseTicks + 5);
  EXPECT_EQ(network_.match().round(), 2U);
}

// Before, the round was over as soon as the second player joined, if the first one had waited for five minutes, and the
// time that they share had run since its first key.
TEST(MatchAloneForTwo, TheRoundBeginsAnewWhenTheSecondPlayerJoins) {
  FakeClientNetwork network(Match(LevelRotation({levelOf("# players: 2\n" + shortWayText())}),
                                  {.maxPlayers = 4, .serverName = "Test", .waitsForOne = true}),
                            {.delayMs = kTickMs});
  network.add(FakeClient("P", 12, [](std::uint32_t tick) { return tick < 60 ? +Input::kLeft : 0; }));
  network.run(kRoundTicks + 600);
  EXPECT_EQ(network.match().round(), 1U);
  EXPECT_NE(network.match().game().player(0).startedAt, 0U);
  network.add(FakeClient("Q", 12, idle));
  network.run(60);
  EXPECT_EQ(network.match().round(), 2U);
  EXPECT_EQ(network.count(MatchEvent::Kind::kRoundEnd), 0U);
  EXPECT_GT(network.match().game().ticksLeft(), kRoundTicks - 120);
  EXPECT_EQ(network.match().game().player(1).present, 1U);
  network.add(FakeClient("R", 12, idle));
  network.run(60);
  EXPECT_EQ(network.match().round(), 2U) << "enough were there";
}

TEST_F(MatchAlone, ASecondPlayerDoesNotBeginALevelForOneAnew) {
  add(idle);
  network_.run(600);
  add(idle);
  network_.run(60);
  EXPECT_EQ(network_.match().round(), 1U);
}

TEST_F(MatchAlone, ASecondPlayerInThePauseIsToldWhenTheNextRoundStarts) {
  add(running);
  network_.run(300);
  ASSERT_EQ(network_.client(1).roundEnd()->pauseTicks, 0U);
  add(idle);
  network_.run(10);
  EXPECT_EQ(network_.client(1).roundEnd()->pauseTicks, MatchRounds::kPauseTicks);
  network_.run(MatchRounds::kPauseTicks);
  EXPECT_EQ(network_.match().round(), 2U);
}

}  // namespace
}  // namespace platon::match_alone_test
