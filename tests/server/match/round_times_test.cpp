// Which times a match offers as best times, and when it announces them.
#include "server/match/round_times.h"

#include <gtest/gtest.h>

#include <string>

#include "server/match/match.h"
#include "tests/net/support/fake_client.h"
#include "tests/net/support/fake_client_network.h"
#include "tests/server/match/kept_times.h"
#include "tests/support/test_levels.h"

namespace platon::round_times_test {
namespace {

/// Players who run to the goal.
class BestTimeOfMatch : public testing::Test {
 protected:
  // A floor on which a player that runs to the right reaches the goal within two seconds.
  static std::string shortWayText() {
    return "HEXAHEDRON\n0 -100 -180 0\n0 0 -190\n480\n%\n-240 -200 240 -200\n-120 -200 -120 0\n%\n%\n%\n%\n%\n";
  }

  void addRunner(const std::string& name, std::uint32_t pause) {
    network_.add(FakeClient(name, 12, [pause](std::uint32_t tick) { return tick < pause ? 0 : +Input::kRight; }));
  }
  // Begins its attempt at once and then stands for a while.
  void addDawdler(const std::string& name, std::uint32_t pause) {
    network_.add(FakeClient(
        name, 12, [pause](std::uint32_t tick) -> int { return tick > 25 && tick < 25 + pause ? 0 : +Input::kRight; }));
  }
  void playRound() {
    const std::uint32_t round = network_.match().round();
    while (network_.match().round() == round) network_.tick();
  }

  KeptTimes times_;
  FakeClientNetwork network_{Match(LevelRotation({levelOf(shortWayText())}), {4, "Test"}, {.bestTimes = &times_}),
                             {.delayMs = kTickMs}};
};

TEST_F(BestTimeOfMatch, EachFinishIsOfferedOnceAndTheBestIsAnnounced) {
  addDawdler("Ann", 40);
  addDawdler("Ben", 20);
  playRound();
  ASSERT_EQ(times_.offered.size(), 2u);
  EXPECT_EQ(times_.offered[0].name, "Ben");
  EXPECT_EQ(times_.offered[1].name, "Ann");
  EXPECT_LT(times_.offered[0].ticks, times_.offered[1].ticks);
  ASSERT_TRUE(network_.client(1).roundEnd());
  EXPECT_EQ(network_.client(1).roundEnd()->best, (LevelBest{times_.offered[0].ticks, "Ben", true}));
}

TEST_F(BestTimeOfMatch, AnEqualTimeIsNotNew) {
  addRunner("Ann", 30);
  playRound();
  const std::uint32_t best = times_.offered.at(0).ticks;
  playRound();
  playRound();
  ASSERT_EQ(times_.offered.size(), 3u);
  EXPECT_EQ(network_.client(1).roundEnd()->best, (LevelBest{best, "Ann", false}));
}

TEST_F(BestTimeOfMatch, AMutedPlayerIsNamedByItsNumber) {
  addRunner("Ann", 30);
  network_.run(10);
  network_.match().mute(0, true);
  playRound();
  EXPECT_EQ(times_.offered.at(0).name, "Player 1");
}

TEST_F(BestTimeOfMatch, AFinishInThePauseCountsAndIsAnnounced) {
  addRunner("Ann", 30);
  network_.run(20);
  network_.match().endRoundNow();
  network_.run(5);
  ASSERT_TRUE(network_.client(1).roundEnd());
  EXPECT_EQ(network_.client(1).roundEnd()->best, std::nullopt);
  playRound();
  ASSERT_EQ(times_.offered.size(), 1u);
  EXPECT_EQ(network_.client(1).roundEnd()->best, (LevelBest{times_.offered[0].ticks, "Ann", true}));
}

TEST_F(BestTimeOfMatch, OfSeveralAttemptsEachBetterOneIsOffered) {
  // The first attempt pauses on the way to the goal, the next ones do not.
  network_.add(FakeClient("Ann", 12, [](std::uint32_t tick) -> int {
    if (tick % 250 == 249) return Input::kRestart;
    return tick > 20 && tick < 80 ? 0 : +Input::kRight;
  }));
  network_.add(FakeClient("Ben", 12, [](std::uint32_t tick) { return tick / 30 % 2 == 0 ? 0 : +Input::kLeft; }));
  network_.run(1000);
  ASSERT_EQ(network_.match().round(), 1u);
  ASSERT_GE(times_.offered.size(), 2u);
  EXPECT_GT(times_.offered[0].ticks, times_.offered[1].ticks + 40);
  EXPECT_EQ(times_.offered.back().ticks, network_.match().game().player(0).finishTicks);
}

TEST_F(BestTimeOfMatch, AnAttemptInWhichTimesDidNotCountForAWhileIsNotOffered) {
  addDawdler("Ann", 40);
  network_.run(40);
  network_.match().countTimes(false);
  network_.run(5);
  network_.match().countTimes(true);
  playRound();
  EXPECT_TRUE(times_.offered.empty());
  playRound();
  EXPECT_EQ(times_.offered.size(), 1u);
}

TEST_F(BestTimeOfMatch, AnAttemptThatBeginsWhenTimesCountAgainIsOfferedAlsoAfterAShorterOne) {
  network_.add(FakeClient("Ann", 12, [](std::uint32_t tick) -> int {
    if (tick == 249) return Input::kRestart;
    return tick > 258 && tick < 300 ? 0 : +Input::kRight;  // the second attempt pauses
  }));
  network_.add(FakeClient("Ben", 12, [](std::uint32_t tick) { return tick / 30 % 2 == 0 ? 0 : +Input::kLeft; }));
  network_.match().countTimes(false);
  network_.run(200);
  network_.match().countTimes(true);
  network_.run(500);
  ASSERT_EQ(network_.match().round(), 1u);
  ASSERT_EQ(times_.offered.size(), 1u);
  EXPECT_GT(times_.offered[0].ticks, network_.match().game().player(0).finishTicks);
}

TEST_F(BestTimeOfMatch, OnAServerThatKeepsTimesOfOneThoseWithOthersEndWithIt) {
  KeptTimes times;
  FakeClientNetwork network(
      Match(LevelRotation({levelOf(shortWayText())}), {.maxPlayers = 4, .serverName = "Test", .keepsTimesOfOne = true},
            {.bestTimes = &times}),
      {.delayMs = kTickMs});
  network.add(FakeClient("Ann", 12, [](std::uint32_t tick) { return tick < 30 ? 0 : +Input::kRight; }));
  network.add(FakeClient("Ben", 12, [](std::uint32_t tick) { return tick / 30 % 2 == 0 ? 0 : +Input::kLeft; }));
  network.run(40);
  network.match().keepTimesOf({0});
  network.leave(2);  // an attempt that has begun with others is not one alone
  while (network.match().round() == 1) network.tick();
  EXPECT_EQ(times.offered.size(), 1u);
  EXPECT_TRUE(times.lasting.empty());
  while (network.match().round() == 2) network.tick();
  EXPECT_EQ(times.offered.size(), 2u);
  EXPECT_EQ(times.lasting.size(), 1u);
}

// Before, the time of a guest in a level for two was the best time of its host.
TEST_F(BestTimeOfMatch, OnAServerThatKeepsTimesOfOneThoseOfAGuestEndWithIt) {
  KeptTimes times;
  const auto runner = [](std::uint32_t pause) {
    return [pause](std::uint32_t tick) { return tick < pause ? 0 : +Input::kRight; };
  };
  FakeClientNetwork network(
      Match(LevelRotation({levelOf("# players: 2\n" + shortWayText())}),
            {.maxPlayers = 4, .serverName = "Test", .keepsTimesOfOne = true}, {.bestTimes = &times}),
      {.delayMs = kTickMs});
  network.add(FakeClient("Host", 12, runner(60)));
  network.add(FakeClient("Bob", 12, runner(30)));
  network.match().keepTimesOf({0});
  const std::uint32_t round = network.match().round();
  while (network.match().round() == round) network.tick();
  ASSERT_EQ(times.offered.size(), 2u);
  ASSERT_EQ(times.lasting.size(), 1u);
  EXPECT_EQ(times.lasting[0].name, "Host");
}

}  // namespace
}  // namespace platon::round_times_test
