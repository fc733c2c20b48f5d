#include <gtest/gtest.h>

#include "server/match/match.h"
#include "tests/net/support/fake_client.h"
#include "tests/net/support/fake_client_network.h"
#include "tests/support/test_levels.h"

namespace platon::resume_match_test {
namespace {

using Kind = MatchEvent::Kind;

int running(std::uint32_t) { return Input::kRight; }

// A floor between two segments, so that a player that runs comes to rest.
std::string roomText() {
  return "HEXAHEDRON\n0 -100 -150 0\n3 120 80\n480\n"
         "%\n-240 -200 240 -200\n-200 -200 -200 240\n200 -200 200 240\n%\n%\n%\n%\n%\n";
}

class ResumeMatch : public testing::Test {
 protected:
  static Match match(std::uint32_t maxPlayers) {
    return Match(LevelRotation({levelOf(roomText())}), {maxPlayers, "Test"});
  }

  FakeClientNetwork network_{match(2), {.delayMs = 3 * kTickMs}};
};

TEST_F(ResumeMatch, TheTokenResumesThePlayerWhereItIs) {
  network_.add(FakeClient("Ann", 12, [](std::uint32_t tick) { return tick < 90 ? 0 : +Input::kRight; }));
  network_.add(FakeClient("Ben", 12, running));
  network_.run(100);
  const EntityState before = network_.match().game().world().entities()[0];
  network_.disconnect(1);
  network_.run(300);
  EXPECT_TRUE(network_.match().game().player(0).present);
  const EntityState standing = network_.match().game().world().entities()[0];
  EXPECT_NE(standing.position, before.position);  // the right button was held for one more second
  network_.add(FakeClient(network_.client(1), [](std::uint32_t) { return 0; }));
  network_.run(30);
  const FakeClient& resumed = network_.client(3);
  ASSERT_TRUE(resumed.welcome());
  EXPECT_EQ(resumed.welcome()->slot, 0u);
  EXPECT_EQ(resumed.levels(), 0u);  // its Hello lists the level as known
  EXPECT_EQ(resumed.states(), 1u);
  EXPECT_EQ(resumed.desyncs(), 0u);
  EXPECT_EQ(network_.match().game().world().entities()[0].position, standing.position);
  EXPECT_EQ(network_.match().game().world().entities()[0].part, standing.part);
  EXPECT_EQ(network_.count(Kind::kConnectionLost), 1u);
  EXPECT_EQ(network_.count(Kind::kResumed), 1u);
  EXPECT_EQ(network_.count(Kind::kLeft), 0u);
  for (const auto& [tick, hash] : resumed.hashes()) EXPECT_EQ(hash, network_.hashOf(1, tick)) << tick;
}

TEST_F(ResumeMatch, ADisconnectedPlayerIsKeptForAMinute) {
  network_.add(FakeClient("Ann", 12, running));
  network_.add(FakeClient("Ben", 12, running));
  network_.run(50);
  network_.disconnect(1);
  network_.run(MatchRoster::kResumeTicks);
  EXPECT_TRUE(network_.match().game().player(0).present);
  network_.match().receive(9, Hello{});
  EXPECT_FALSE(network_.match().isPlaying(9));  // its slot is not free
  network_.match().takeOutgoing();
  network_.run(5);
  EXPECT_FALSE(network_.match().game().player(0).present);
  EXPECT_EQ(network_.count(Kind::kLeft), 1u);
  EXPECT_EQ(network_.client(2).roster().at(0), "");
}

TEST_F(ResumeMatch, AfterAMinuteTheTokenResumesNothing) {
  network_.add(FakeClient("Ann", 12, running));
  network_.add(FakeClient("Ben", 12, running));
  network_.run(50);
  network_.disconnect(1);
  network_.run(MatchRoster::kResumeTicks + 5);
  network_.add(FakeClient(network_.client(1), running));
  network_.run(20);
  EXPECT_EQ(network_.count(Kind::kResumed), 0u);
  EXPECT_EQ(network_.count(Kind::kJoined), 3u);
}

TEST_F(ResumeMatch, AnotherTokenResumesNothing) {
  network_.add(FakeClient("Ann", 12, running));
  network_.run(50);
  network_.disconnect(1);
  SessionToken guess = network_.client(1).token();
  guess[15] ^= 1;
  network_.match().receive(9, Hello{kRulesVersion, "Eve", guess});
  ASSERT_TRUE(network_.match().isPlaying(9));
  EXPECT_EQ(network_.match().find(9)->first().slot(), 1u);
}

// A client whose address changes reconnects before the server detects that the old connection is lost.
TEST_F(ResumeMatch, AConnectedPlayerIsResumedAndItsOldConnectionClosed) {
  network_.add(FakeClient("Ann", 12, running));
  network_.run(50);
  network_.add(FakeClient(network_.client(1), running));
  network_.run(30);
  EXPECT_EQ(network_.client(2).welcome()->slot, 0u);
  EXPECT_FALSE(network_.match().isPlaying(1));
  ASSERT_TRUE(network_.client(1).bye());
  EXPECT_EQ(network_.client(1).bye()->code, ByeCode::kRemoved);
  EXPECT_EQ(network_.match().players(), 1u);
  network_.match().disconnect(1);  // the server detects the loss
  network_.run(30);
  EXPECT_EQ(network_.match().players(), 1u);
  EXPECT_TRUE(network_.match().game().player(0).present);
}

TEST_F(ResumeMatch, APlayerWithoutATokenIsNotKept) {
  network_.match().receive(9, Hello{});
  network_.match().takeOutgoing();
  network_.match().disconnect(9);
  EXPECT_TRUE(network_.match().idle());
}

TEST_F(ResumeMatch, APlayerThatLeavesIsNotKept) {
  network_.add(FakeClient("Ann", 12, running));
  network_.add(FakeClient("Ben", 12, running));
  network_.run(50);
  network_.leave(1);
  network_.run(5);
  EXPECT_FALSE(network_.match().game().player(0).present);
  network_.add(FakeClient(network_.client(1), running));
  network_.run(30);
  EXPECT_EQ(network_.count(Kind::kResumed), 0u);
}

TEST_F(ResumeMatch, AGameWithOnlyDisconnectedPlayersIsPausedAfterAMinute) {
  network_.add(FakeClient("Ann", 12, running));
  network_.run(50);
  network_.disconnect(1);
  network_.run(MatchRoster::kResumeTicks + 10);
  EXPECT_TRUE(network_.match().idle());
  const std::uint32_t tick = network_.match().game().tick();
  network_.run(20);
  EXPECT_EQ(network_.match().game().tick(), tick);
}

TEST_F(ResumeMatch, InputsSentAheadByTheOldClientAreDiscarded) {
  network_.add(FakeClient("Ann", 100, running));
  network_.run(50);
  network_.disconnect(1);
  network_.add(FakeClient(network_.client(1), [](std::uint32_t) { return 0; }));
  network_.run(40);
  const auto& decided = network_.client(2).decided();
  ASSERT_FALSE(decided.empty());
  EXPECT_EQ(decided.rbegin()->second, Input{Input::kPresent});
}

}  // namespace
}  // namespace platon::resume_match_test
