#include <gtest/gtest.h>

#include "server/match/match.h"
#include "tests/net/support/fake_client.h"
#include "tests/net/support/fake_client_network.h"
#include "tests/support/test_levels.h"

namespace platon::match_control_test {
namespace {

using Kind = MatchEvent::Kind;

class MatchControlTest : public testing::Test {
 protected:
  static FakeClient player(const std::string& name) {
    return FakeClient(name, 8, [](std::uint32_t tick) { return static_cast<int>(tick / 7 % 8); });
  }

  Match& match() { return network_.match(); }

  FakeClientNetwork network_{Match(LevelRotation({levelOf(farGoalText()), levelOf(nearGoalText())}), {4, "Test"})};
};

TEST_F(MatchControlTest, KickTellsTheClientWhyAndRemovesItsPlayer) {
  network_.add(player("Ann"));
  network_.add(player("Ben"));
  network_.run(30);
  EXPECT_TRUE(match().kick(1, "too loud"));
  EXPECT_FALSE(match().isPlaying(2));
  network_.run(30);
  ASSERT_TRUE(network_.client(2).bye());
  EXPECT_EQ(network_.client(2).bye()->code, ByeCode::kRemoved);
  EXPECT_EQ(network_.client(2).bye()->reason, "too loud");
  EXPECT_EQ(network_.count(Kind::kLeft), 1u);
  EXPECT_EQ(network_.client(1).roster().at(1), "");
  EXPECT_FALSE(match().game().player(1).present);
  EXPECT_FALSE(network_.client(1).bye());
  EXPECT_EQ(network_.client(1).desyncs(), 0u);
}

TEST_F(MatchControlTest, TheMessageOfAKickClosesTheConnection) {
  match().receive(1, Hello{});
  match().takeOutgoing();
  EXPECT_TRUE(match().kick(0, "too loud"));
  const std::span<const Outgoing> sent = match().takeOutgoing();
  ASSERT_EQ(sent.size(), 1u);
  EXPECT_EQ(sent[0].client, 1u);
  EXPECT_TRUE(sent[0].reliable && sent[0].last);
}

// Without this the player would come back by itself within a second.
TEST_F(MatchControlTest, AKickedPlayerCannotBeResumed) {
  network_.add(player("Ann"));
  network_.add(player("Ben"));
  network_.run(20);
  match().kick(1, "");
  network_.run(20);
  network_.add(FakeClient(network_.client(2), [](std::uint32_t) { return 0; }));
  network_.run(20);
  EXPECT_EQ(network_.count(Kind::kResumed), 0u);
  EXPECT_EQ(network_.count(Kind::kJoined), 3u);
}

TEST_F(MatchControlTest, KickRemovesADisconnectedPlayer) {
  network_.add(player("Ann"));
  network_.add(player("Ben"));
  network_.run(20);
  network_.disconnect(2);
  network_.run(20);
  EXPECT_TRUE(match().kick(1, "too loud"));
  EXPECT_EQ(match().playerStatus().size(), 1u);
  network_.run(5);
  EXPECT_FALSE(match().game().player(1).present);
}

TEST_F(MatchControlTest, KickAndMuteOfAnEmptySlotDoNothing) {
  network_.add(player("Ann"));
  network_.run(20);
  for (const std::uint32_t slot : {1u, 3u, 4u, 4294967295u}) {
    EXPECT_FALSE(match().kick(slot, ""));
    EXPECT_FALSE(match().mute(slot, true));
  }
  EXPECT_EQ(match().players(), 1u);
}

TEST_F(MatchControlTest, AMutedPlayerIsShownByItsNumber) {
  network_.add(player("Ann"));
  network_.add(player("Ben"));
  network_.run(30);
  EXPECT_TRUE(match().mute(1, true));
  network_.run(30);
  network_.add(player("Cid"));
  network_.run(30);
  for (const ClientId client : {1u, 2u, 3u}) EXPECT_EQ(network_.client(client).roster().at(1), "Player 2") << client;
  EXPECT_TRUE(match().mute(1, false));
  network_.run(30);
  for (const ClientId client : {1u, 2u, 3u}) EXPECT_EQ(network_.client(client).roster().at(1), "Ben") << client;
  EXPECT_EQ(network_.client(1).roster().at(0), "Ann");
}

TEST_F(MatchControlTest, AMutedPlayerStaysMutedWhenItResumes) {
  network_.add(player("Ann"));
  network_.add(player("Ben"));
  network_.run(30);
  network_.disconnect(2);
  EXPECT_TRUE(match().mute(1, true));
  network_.run(30);
  network_.add(FakeClient(network_.client(2), [](std::uint32_t) { return 0; }));
  network_.run(30);
  EXPECT_EQ(network_.count(Kind::kResumed), 1u);
  EXPECT_EQ(network_.client(1).roster().at(1), "Player 2");
  EXPECT_EQ(network_.client(3).roster().at(1), "Player 2");
}

TEST_F(MatchControlTest, ThePlayerAfterAMutedOneIsShownByName) {
  network_.add(player("Ann"));
  network_.add(player("Ben"));
  network_.run(30);
  match().mute(1, true);
  network_.leave(2);
  network_.run(30);
  network_.add(player("Cid"));
  network_.run(30);
  EXPECT_EQ(network_.client(1).roster().at(1), "Cid");
}

TEST_F(MatchControlTest, SayGoesToEveryConnectedPlayerReliably) {
  for (const ClientId client : {1u, 2u, 3u}) {
    Hello hello;
    hello.token = SessionToken{static_cast<std::uint8_t>(client)};
    match().receive(client, hello);
  }
  match().disconnect(2);
  match().takeOutgoing();
  match().say("hello");
  const std::span<const Outgoing> sent = match().takeOutgoing();
  ASSERT_EQ(sent.size(), 2u);
  EXPECT_EQ(sent[0].client, 1u);
  EXPECT_EQ(sent[1].client, 3u);
  for (const Outgoing& message : sent) {
    EXPECT_TRUE(message.reliable);
    EXPECT_FALSE(message.last);
    EXPECT_EQ(decodeToClient(message.bytes), ToClient(Notice{"hello"}));
  }
}

TEST_F(MatchControlTest, SayReachesThePlayersInTheGame) {
  network_.add(player("Ann"));
  network_.run(30);
  match().say("restart at\xe2\x80\x8b noon");
  match().say("restart at one");
  network_.run(30);
  EXPECT_EQ(network_.client(1).notices(), (std::vector<std::string>{"restart at noon", "restart at one"}));
  EXPECT_EQ(network_.client(1).desyncs(), 0u);
}

TEST_F(MatchControlTest, ARoundThatIsEndedGoesOnForThePause) {
  network_.add(player("Ann"));
  network_.run(50);
  EXPECT_TRUE(match().endRoundNow());
  EXPECT_FALSE(match().endRoundNow());
  const std::uint32_t end = match().game().tick();
  network_.run(MatchRounds::kPauseTicks - 1);
  EXPECT_EQ(match().round(), 1u);
  ASSERT_TRUE(network_.client(1).roundEnd());
  EXPECT_EQ(network_.client(1).roundEnd()->tick, end);
  EXPECT_EQ(network_.client(1).roundEnd()->nextLevelHash, levelOf(nearGoalText())->hash);
  network_.run(30);
  EXPECT_EQ(match().round(), 2u);
  EXPECT_EQ(network_.client(1).round(), 2u);
  EXPECT_EQ(match().game().level().hash, levelOf(nearGoalText())->hash);
  EXPECT_EQ(network_.client(1).desyncs(), 0u);
  EXPECT_GE(network_.count(Kind::kRoundEnd), 1u);
}

TEST_F(MatchControlTest, WithoutPlayersTheNextRoundStartsAtOnce) {
  EXPECT_TRUE(match().endRoundNow());
  EXPECT_EQ(match().round(), 2u);
  EXPECT_EQ(match().game().level().hash, levelOf(nearGoalText())->hash);
  EXPECT_TRUE(match().endRoundNow());
  EXPECT_EQ(match().game().level().hash, levelOf(farGoalText())->hash);
}

TEST_F(MatchControlTest, TheNextRoundCanStartAtOnceWithANewVersionOfItsLevel) {
  network_.add(player("Ann"));
  network_.run(50);
  match().updateLevels({levelOf(nearGoalText()), levelOf("# title: changed\n" + nearGoalText())});
  EXPECT_EQ(match().game().level().hash, levelOf(farGoalText())->hash) << "the round goes on";
  match().startNextRound();
  EXPECT_EQ(match().round(), 2u);
  EXPECT_EQ(match().game().level().title, "changed");
  network_.run(60);
  EXPECT_EQ(network_.client(1).round(), 2u);
  EXPECT_EQ(network_.client(1).desyncs(), 0u);
}

TEST_F(MatchControlTest, PlayersAreListedBySlotWithTheirPresentAddress) {
  const auto at = [](const char* address) { return *IpAddress::parse(address); };
  EXPECT_TRUE(match().playerStatus().empty());
  for (const ClientId client : {7u, 5u, 6u}) {
    Hello hello;
    hello.name = "P" + std::to_string(client);
    hello.token = SessionToken{static_cast<std::uint8_t>(client)};
    match().receive(client, hello, at("192.0.2.1"));
  }
  EXPECT_TRUE(match().move(6, at("2001:db8::6")));
  match().disconnect(5);
  match().mute(2, true);
  const std::vector<PlayerStatus> expected{{0, "P7", "P7", false, 7, at("192.0.2.1"), 0},
                                           {1, "P5", "P5", false, std::nullopt, at("192.0.2.1"), 0},
                                           {2, "P6", "Player 3", true, 6, at("2001:db8::6"), 0}};
  EXPECT_EQ(match().playerStatus(), expected);
}

TEST_F(MatchControlTest, MissedInputsAreCountedOverAllRounds) {
  network_.add(player("Ann"));
  network_.add(player("Ben"));
  network_.run(50);
  network_.disconnect(2, std::chrono::milliseconds(500));
  network_.run(100);
  EXPECT_EQ(match().missedInputs(), 0u) << "what never comes is not too late";
  PlayerInputs late;
  late.round = match().round();
  late.first = match().game().tick() - 10;
  late.inputs = {Input{Input::kPresent | Input::kDown}, Input{Input::kPresent | Input::kDown | Input::kJump}};
  match().receive(1, late);
  const std::uint64_t missed = match().missedInputs();
  EXPECT_EQ(missed, 2u);
  match().endRoundNow();
  network_.run(MatchRounds::kPauseTicks + 5);
  EXPECT_EQ(match().round(), 2u);
  EXPECT_EQ(match().missedInputs(), missed);
}

TEST_F(MatchControlTest, AMatchThatDrainsLetsNoNewPlayerJoin) {
  network_.add(player("Ann"));
  network_.run(20);
  match().drain("Soon over.", {RefusalCode::kOther, "go elsewhere", "example.org:1"});
  network_.add(player("Ben"));
  network_.run(20);
  ASSERT_TRUE(network_.client(2).refused());
  EXPECT_EQ(*network_.client(2).refused(), (Refused{RefusalCode::kOther, "go elsewhere", "example.org:1"}));
  EXPECT_TRUE(match().isPlaying(1));
  EXPECT_FALSE(match().isPlaying(2));
}

TEST_F(MatchControlTest, AMatchThatDrainsLetsItsPlayersResume) {
  network_.add(player("Ann"));
  network_.add(player("Ben"));
  network_.run(20);
  network_.disconnect(2);
  match().drain("Soon over.", {RefusalCode::kOther, "go elsewhere", "example.org:1"});
  network_.run(20);
  network_.add(FakeClient(network_.client(2), [](std::uint32_t) { return 0; }));
  network_.run(20);
  EXPECT_EQ(network_.count(Kind::kResumed), 1u);
  EXPECT_EQ(network_.count(Kind::kRefused), 0u);
}

TEST_F(MatchControlTest, AMatchThatDrainsStartsNoOtherRound) {
  network_.add(player("Ann"));
  network_.run(20);
  match().drain("Soon over.", {RefusalCode::kOther, "go elsewhere", "example.org:1"});
  EXPECT_FALSE(match().drained());
  EXPECT_TRUE(match().endRoundNow());
  network_.run(MatchRounds::kPauseTicks - 1);
  EXPECT_FALSE(match().drained());
  network_.run(1);
  EXPECT_TRUE(match().drained());
  network_.run(100);
  EXPECT_EQ(match().round(), 1u);
  EXPECT_EQ(network_.client(1).desyncs(), 0u);
}

TEST_F(MatchControlTest, AMatchThatDrainsIsDrainedWhenItsLastPlayerHasLeft) {
  network_.add(player("Ann"));
  network_.run(20);
  match().drain("Soon over.", {RefusalCode::kOther, "go elsewhere", "example.org:1"});
  EXPECT_FALSE(match().drained());
  network_.leave(1);
  network_.run(2);
  EXPECT_TRUE(match().drained());
}

}  // namespace
}  // namespace platon::match_control_test
