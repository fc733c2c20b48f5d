#include <gtest/gtest.h>

#include "server/match/match.h"
#include "tests/support/fake_client.h"
#include "tests/support/test_levels.h"
#include "tests/support/virtual_network.h"

namespace platon {
namespace {

using Kind = MatchEvent::Kind;

int running(std::uint32_t) { return Input::kRight; }

// A room between two walls, so that who is alone comes to rest.
std::string roomText() {
  return "HEXAHEDRON\n0 -100 -150 0\n3 120 80\n480\n"
         "%\n-240 -200 240 -200\n-200 -200 -200 240\n200 -200 200 240\n%\n%\n%\n%\n%\n";
}

class Reconnect : public testing::Test {
 protected:
  static Match match(std::uint32_t maxPlayers) {
    return Match(LevelRotation({levelOf(roomText())}), {maxPlayers, "Test"});
  }

  VirtualNetwork network_{match(2), {3, 0, 0, 1}};
};

TEST_F(Reconnect, TheTokenTakesBackThePlayerWhereItIs) {
  network_.add(FakeClient("Ann", 12, [](std::uint32_t tick) { return tick < 90 ? 0 : +Input::kRight; }));
  network_.add(FakeClient("Ben", 12, running));
  network_.run(100);
  const EntityState before = network_.match().game().world().entities()[0];
  network_.breakOff(1);
  network_.run(300);
  EXPECT_TRUE(network_.match().game().player(0).present);
  const EntityState standing = network_.match().game().world().entities()[0];
  EXPECT_NE(standing.position, before.position);  // held right for a second more
  network_.add(FakeClient(network_.client(1), [](std::uint32_t) { return 0; }));
  network_.run(30);
  const FakeClient& back = network_.client(3);
  ASSERT_TRUE(back.welcome());
  EXPECT_EQ(back.welcome()->slot, 0u);
  EXPECT_EQ(back.levels(), 0u);  // it had said that it knows the level
  EXPECT_EQ(back.states(), 1u);
  EXPECT_EQ(back.desyncs(), 0u);
  EXPECT_EQ(network_.match().game().world().entities()[0].position, standing.position);
  EXPECT_EQ(network_.match().game().world().entities()[0].part, standing.part);
  EXPECT_EQ(network_.count(Kind::kLost), 1u);
  EXPECT_EQ(network_.count(Kind::kReturned), 1u);
  EXPECT_EQ(network_.count(Kind::kLeft), 0u);
  for (const auto& [tick, hash] : back.hashes()) EXPECT_EQ(hash, network_.hashOf(1, tick)) << tick;
}

TEST_F(Reconnect, ThePlayerIsKeptForAMinute) {
  network_.add(FakeClient("Ann", 12, running));
  network_.add(FakeClient("Ben", 12, running));
  network_.run(50);
  network_.breakOff(1);
  network_.run(Match::kAwayTicks);
  EXPECT_TRUE(network_.match().game().player(0).present);
  network_.match().receive(9, Hello{});
  EXPECT_FALSE(network_.match().isMember(9));  // its slot is not given away
  network_.match().takeOutgoing();
  network_.run(5);
  EXPECT_FALSE(network_.match().game().player(0).present);
  EXPECT_EQ(network_.count(Kind::kLeft), 1u);
  EXPECT_EQ(network_.client(2).roster().at(0), "");
}

TEST_F(Reconnect, AfterAMinuteTheTokenIsWorthNothing) {
  network_.add(FakeClient("Ann", 12, running));
  network_.add(FakeClient("Ben", 12, running));
  network_.run(50);
  network_.breakOff(1);
  network_.run(Match::kAwayTicks + 5);
  network_.add(FakeClient(network_.client(1), running));
  network_.run(20);
  EXPECT_EQ(network_.count(Kind::kReturned), 0u);
  EXPECT_EQ(network_.count(Kind::kJoined), 3u);
}

TEST_F(Reconnect, AnotherTokenIsWorthNothing) {
  network_.add(FakeClient("Ann", 12, running));
  network_.run(50);
  network_.breakOff(1);
  SessionToken guess = network_.client(1).token();
  guess[15] ^= 1;
  network_.match().receive(9, Hello{kProtocolVersion, kRulesVersion, "Eve", guess});
  ASSERT_TRUE(network_.match().isMember(9));
  EXPECT_EQ(network_.match().member(9)->slot(), 1u);
}

// After its address has changed a client is back before the server has noticed that the old connection is dead.
TEST_F(Reconnect, TheOldConnectionGivesWay) {
  network_.add(FakeClient("Ann", 12, running));
  network_.run(50);
  network_.add(FakeClient(network_.client(1), running));
  network_.run(30);
  EXPECT_EQ(network_.client(2).welcome()->slot, 0u);
  EXPECT_FALSE(network_.match().isMember(1));
  ASSERT_TRUE(network_.client(1).bye());
  EXPECT_EQ(network_.client(1).bye()->code, ByeCode::kRemoved);
  EXPECT_EQ(network_.match().players(), 1u);
  network_.match().disconnect(1);  // now it has
  network_.run(30);
  EXPECT_EQ(network_.match().players(), 1u);
  EXPECT_TRUE(network_.match().game().player(0).present);
}

TEST_F(Reconnect, WhoCannotComeBackIsNotKept) {
  network_.match().receive(9, Hello{});
  network_.match().takeOutgoing();
  network_.match().disconnect(9);
  EXPECT_TRUE(network_.match().idle());
}

TEST_F(Reconnect, WhoLeavesIsNotKept) {
  network_.add(FakeClient("Ann", 12, running));
  network_.add(FakeClient("Ben", 12, running));
  network_.run(50);
  network_.leave(1);
  network_.run(5);
  EXPECT_FALSE(network_.match().game().player(0).present);
  network_.add(FakeClient(network_.client(1), running));
  network_.run(30);
  EXPECT_EQ(network_.count(Kind::kReturned), 0u);
}

// With everybody away the game goes on for the minute, and then stands still.
TEST_F(Reconnect, AGameOfWhichAllAreAwayEndsAfterAMinute) {
  network_.add(FakeClient("Ann", 12, running));
  network_.run(50);
  network_.breakOff(1);
  network_.run(Match::kAwayTicks + 10);
  EXPECT_TRUE(network_.match().idle());
  const std::uint32_t tick = network_.match().game().tick();
  network_.run(20);
  EXPECT_EQ(network_.match().game().tick(), tick);
}

// What the lost client had sent ahead is not played by the one that comes back.
TEST_F(Reconnect, InputsOfTheLostClientAreForgotten) {
  network_.add(FakeClient("Ann", 100, running));
  network_.run(50);
  network_.breakOff(1);
  network_.add(FakeClient(network_.client(1), [](std::uint32_t) { return 0; }));
  network_.run(40);
  const auto& decided = network_.client(2).decided();
  ASSERT_FALSE(decided.empty());
  EXPECT_EQ(decided.rbegin()->second, Input{Input::kPresent});
}

// Of four messages one repeats all that is not acknowledged, the others only the last ticks.
TEST(MemberParts, RepeatWhatMayBeLostAndNowAndThenAll) {
  MatchPlayer member(0, "Ann", std::nullopt);
  member.acknowledge(100);
  std::vector<std::uint32_t> starts;
  for (int message = 0; message < 5; ++message) {
    starts.push_back(member.nextPart(140));
    member.sentUpTo(140, 140);
    member.nextSequence();
  }
  EXPECT_EQ(starts, (std::vector<std::uint32_t>{100, 132, 132, 132, 100}));
  member.acknowledge(135);
  EXPECT_EQ(member.nextPart(140), 135u);
  EXPECT_EQ(member.nextPart(3), 135u);
}

TEST(MemberParts, GoOnWhereNotAllFittedIn) {
  MatchPlayer member(0, "Ann", std::nullopt);
  member.acknowledge(100);
  member.sentUpTo(340, 500);
  member.nextSequence();
  EXPECT_EQ(member.nextPart(500), 340u);
  member.sentUpTo(500, 500);
  EXPECT_EQ(member.nextPart(500), 492u);
}

TEST(MemberLine, TellsTheOldestNewInputThatChangesTheButtons) {
  const auto press = [](int buttons) { return Input{static_cast<std::uint8_t>(buttons | Input::kPresent)}; };
  MatchPlayer member(0, "Ann", std::nullopt);
  const auto take = [&member](const PlayerInputs& message, std::uint32_t decided) {
    member.hear(message.sequence);
    member.take(message, decided);
  };
  take({1, 0, 0, 0, 10, {press(1), press(1), press(1)}, 5}, 8);
  auto line = member.takeLine();
  ASSERT_TRUE(line && line->slack);
  EXPECT_EQ(line->sequence, 5);
  EXPECT_EQ(line->slack, (SlackReport{12, 4}));  // nothing changed, the newest
  EXPECT_FALSE(member.takeLine());

  // The message with the change at 13 was lost.
  take({1, 0, 0, 0, 10, {press(1), press(1), press(1), press(2), press(2)}, 7}, 14);
  line = member.takeLine();
  ASSERT_TRUE(line && line->slack);
  EXPECT_EQ(line->slack, (SlackReport{13, -1}));
  EXPECT_EQ(line->lostPercent, 33);

  // A change right after what is known, and a repetition that is no news.
  take({1, 0, 0, 0, 15, {press(4)}, 8}, 14);
  take({1, 0, 0, 0, 14, {press(2), press(4)}, 9}, 15);
  line = member.takeLine();
  ASSERT_TRUE(line && line->slack);
  EXPECT_EQ(line->slack, (SlackReport{15, 1}));
  take({1, 0, 0, 0, 14, {press(2), press(4)}, 10}, 16);
  line = member.takeLine();
  ASSERT_TRUE(line);
  EXPECT_FALSE(line->slack);
  EXPECT_EQ(line->sequence, 10);
}

}  // namespace
}  // namespace platon
