// Several players of one connection. Those who misuse it: hostile_companions_test.
#include "tests/net/support/fake_client.h"
#include "tests/net/support/fake_client_network.h"
#include "tests/server/match/companion_fixture.h"
#include "tests/server/match/kept_times.h"

namespace platon::match_companions_test {
namespace {

using Kind = MatchEvent::Kind;
using Names = std::map<std::uint32_t, std::string>;
using Texts = std::vector<std::string>;

constexpr auto kNone = std::nullopt;

int idle(std::uint32_t) { return 0; }
int running(std::uint32_t) { return Input::kRight; }

// A floor on which a player that runs to the right reaches the goal within two seconds.
std::string shortWayText() {
  return "HEXAHEDRON\n0 -100 -180 0\n0 0 -190\n480\n%\n-240 -200 240 -200\n-120 -200 -120 0\n%\n%\n%\n%\n%\n";
}

class MatchCompanions : public CompanionTest {};

TEST_F(MatchCompanions, ACompanionHasASlotAndANameOfItsOwn) {
  join(1, "Ann");
  join(2, "Ben");
  EXPECT_EQ(add(1, 1, "Cid"), (LocalSlots{{0, 2}}));
  EXPECT_EQ(add(1, 3, "Dan"), (LocalSlots{{0, 2, kNone, 3}}));
  EXPECT_EQ(add(2, 1, "Eve"), (LocalSlots{{1, 4}}));
  EXPECT_EQ(names(), (Names{{0, "Ann"}, {1, "Ben"}, {2, "Cid"}, {3, "Dan"}, {4, "Eve"}}));
  EXPECT_EQ(events(), (Texts{"joined 1 2 Cid", "joined 1 3 Dan", "joined 2 4 Eve"}));
  EXPECT_EQ(match_.players(), 5u);
  EXPECT_EQ(match_.allPlayers(), 5u);
}

TEST_F(MatchCompanions, TheOperatorSeesWhoPlaysWithWhom) {
  join(1, "Ann", 7);
  add(1, 2, "Ben");
  const std::vector<PlayerStatus> expected{{0, "Ann", "Ann", false, 1, addressOf(7), 0},
                                           {1, "Ben", "Ben", false, 1, addressOf(7), 0, 0}};
  EXPECT_EQ(match_.playerStatus(), expected);
}

TEST_F(MatchCompanions, EverybodyLearnsItsName) {
  join(1, "Ann");
  join(2, "Ben");
  run(MatchUpdates::kNamesTicks);
  forget();
  add(1, 1, "Cid");
  run(MatchUpdates::kNamesTicks);
  const std::vector<Roster> told = sentTo<Roster>(2);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0], (Roster{{{2, "Cid"}}}));
}

TEST_F(MatchCompanions, NoTwoPlayersHaveOneName) {
  join(1, "Ann");
  add(1, 1, "Ann");
  add(1, 2, "ann");
  add(1, 3, "");
  EXPECT_EQ(names(), (Names{{0, "Ann"}, {1, "Ann 2"}, {2, "ann 3"}, {3, "Player 4"}}));
}

TEST_F(MatchCompanions, OneThatPlaysGetsAnotherName) {
  join(1, "Ann");
  add(1, 1, "Ben");
  events();
  EXPECT_EQ(add(1, 1, "Cid"), (LocalSlots{{0, 1}}));
  EXPECT_EQ(names().at(1), "Cid");
  EXPECT_EQ(events(), (Texts{"renamed 1 1 Cid"}));
  EXPECT_EQ(add(1, 1, "Cid"), (LocalSlots{{0, 1}}));
  EXPECT_EQ(events(), Texts{}) << "it has this name";
  EXPECT_EQ(add(1, 2, "Ben"), (LocalSlots{{0, 1, 2}})) << "the old name is free";
  EXPECT_EQ(names().at(2), "Ben");
}

TEST_F(MatchCompanions, OneThatLeavesFreesItsSlotAndItsName) {
  join(1, "Ann");
  add(1, 1, "Ben");
  press(1, 0, {1});
  run();
  ASSERT_TRUE(isPresent(1));
  events();
  EXPECT_EQ(drop(1, 1), (LocalSlots{{0}}));
  EXPECT_EQ(events(), (Texts{"left 1 1 Ben"}));
  EXPECT_EQ(add(1, 1, "Ben"), (LocalSlots{{0, 2}})) << "slot 1 is not free before a tick without it";
  EXPECT_EQ(names(), (Names{{0, "Ann"}, {2, "Ben"}}));
  run();
  EXPECT_FALSE(isPresent(1));
  join(2, "Cid");
  EXPECT_EQ(match_.find(2)->first().slot(), 1u);
}

TEST_F(MatchCompanions, AllLeaveTogether) {
  join(1, "Ann");
  join(2, "Ben");
  add(1, 1, "Cid");
  add(1, 2, "Dan");
  events();
  match_.receive(1, Leave{});
  EXPECT_EQ(events(), (Texts{"left 1 0 Ann", "left 1 2 Cid", "left 1 3 Dan"}));
  EXPECT_EQ(names(), (Names{{1, "Ben"}}));
}

TEST_F(MatchCompanions, AMatchForOneIsFullWithTheFirstPlayer) {
  match_ = Match(LevelRotation({levelOf(farGoalText())}), {.maxPlayers = 1});
  join(1, "Ann");
  EXPECT_EQ(add(1, 1, "Ben"), (LocalSlots{{0}, "the server is full (1 players): try again later"}));
  EXPECT_EQ(names(), (Names{{0, "Ann"}}));
  EXPECT_EQ(events(), Texts{});
}

TEST_F(MatchCompanions, AMatchThatDrainsLetsNoCompanionJoin) {
  join(1, "Ann");
  add(1, 1, "Ben");
  events();
  match_.drain("Soon over.", {RefusalCode::kOther, "this server is about to stop"});
  EXPECT_EQ(add(1, 2, "Cid"), (LocalSlots{{0, 1}, "this server is about to stop"}));
  EXPECT_EQ(events(), Texts{});
  EXPECT_EQ(add(1, 1, "Dan"), (LocalSlots{{0, 1}})) << "a name may change";
  EXPECT_EQ(drop(1, 1), (LocalSlots{{0}}));
}

TEST_F(MatchCompanions, ACompanionAppearsWithItsFirstInput) {
  join(1, "Ann");
  press(1, 0, {});
  run(20);
  add(1, 1, "Ben");
  press(1, 0, {});
  run();
  EXPECT_TRUE(isPresent(0));
  EXPECT_FALSE(isPresent(1));
  press(1, Input::kLeft, {1});
  run();
  ASSERT_TRUE(isPresent(1));
  EXPECT_EQ(match_.game().player(1).held & ~Input::kPresent, Input::kLeft);
}

TEST_F(MatchCompanions, EachSpeaksForItself) {
  join(1, "Ann");
  join(2, "Ben");
  add(1, 2, "Cid");
  events();
  match_.receive(1, LocalChat{2, {"Here!", 0}});
  EXPECT_EQ(sentTo<PlayerChat>(2), (std::vector<PlayerChat>{{2, {"Here!", 0}}}));
  EXPECT_EQ(events(), (Texts{"chat 1 2 Here!"}));
  match_.receive(1, LocalChat{1, {"Nobody", 0}});
  EXPECT_TRUE(sentTo<PlayerChat>(2).empty());
}

TEST_F(MatchCompanions, EachHasWhatOnePlayerMaySay) {
  join(1, "Ann");
  add(1, 1, "Ben");
  for (int i = 0; i < 10; ++i) {
    for (const std::uint32_t local : {0u, 1u}) match_.receive(1, LocalChat{local, {"", 1}});
  }
  const std::vector<PlayerChat> heard = sentTo<PlayerChat>(1);
  EXPECT_EQ(std::count_if(heard.begin(), heard.end(), [](const PlayerChat& chat) { return chat.slot == 0; }), 4);
  EXPECT_EQ(std::count_if(heard.begin(), heard.end(), [](const PlayerChat& chat) { return chat.slot == 1; }), 4);
}

TEST_F(MatchCompanions, AMutedCompanionIsNotHeardAndTheOthersAre) {
  join(1, "Ann");
  add(1, 1, "Ben");
  EXPECT_TRUE(match_.mute(1, true));
  forget();
  for (const std::uint32_t local : {0u, 1u}) match_.receive(1, LocalChat{local, {"a", 0}});
  EXPECT_EQ(sentTo<PlayerChat>(1), (std::vector<PlayerChat>{{0, {"a", 0}}}));
  add(1, 1, "Cid");
  EXPECT_TRUE(match_.playerStatus()[1].muted) << "another name does not help";
  EXPECT_EQ(match_.playerStatus()[1].shownName, "Player 2");
}

// It was heard again as soon as it left and came back.
TEST_F(MatchCompanions, AMutedCompanionThatLeavesAndReturnsIsMuted) {
  join(1, "Ann");
  add(1, 1, "Ben");
  EXPECT_TRUE(match_.mute(1, true));
  drop(1, 1);
  run();
  add(1, 2, "Cid");
  EXPECT_TRUE(match_.playerStatus()[1].muted) << "under any number";
  join(2, "Dan");
  EXPECT_FALSE(match_.playerStatus()[2].muted);
}

TEST_F(MatchCompanions, TheRoundTripOfAConnectionIsThatOfAllItsPlayers) {
  MatchProgram program;
  program.roundTrip = [](ClientId id) { return 20 * id; };
  match_ = Match(LevelRotation({levelOf(farGoalText())}), {}, program);
  join(1, "Ann");
  add(1, 1, "Ben");
  run(MatchUpdates::kRoundTripsTicks);
  EXPECT_TRUE(sentTo<RoundTrips>(1).empty()) << "nobody plays elsewhere";
  join(2, "Cid");
  run(MatchUpdates::kRoundTripsTicks);
  const std::uint8_t near = codeOfRoundTrip(20);
  EXPECT_EQ(sentTo<RoundTrips>(2), (std::vector<RoundTrips>{{{near, near, codeOfRoundTrip(40)}}}));
}

// As with as many connections.
TEST_F(MatchCompanions, TicksAreSentAsRarelyAsWithThatManyPlayers) {
  join(1, "Ann");
  for (const std::uint32_t local : {1u, 2u, 3u}) add(1, local, "P");
  forget();
  run(60);
  EXPECT_EQ(sentTo<ConfirmedTicks>(1).size(), 60u);
  join(2, "Eve");
  run(60);
  EXPECT_EQ(sentTo<ConfirmedTicks>(1).size(), 30u) << "of five players";
}

class CompanionVotes : public CompanionTest {
 protected:
  void vote(ClientId id, bool next = true) { match_.receive(id, Vote{match_.round(), next}); }
  std::vector<VoteCount> counts() {
    run();
    return sentTo<VoteCount>(1);
  }
};

TEST_F(CompanionVotes, AWishCountsForEachPlayerOfItsConnection) {
  for (const ClientId id : {1u, 2u, 3u}) join(id, "P");
  add(2, 1, "Q");
  vote(2);
  EXPECT_EQ(counts(), (std::vector<VoteCount>{{1, 2, 4}}));
  vote(1);
  run();
  EXPECT_EQ(sentTo<RoundEnd>(1).size(), 1u) << "3 of 4";
}

TEST_F(CompanionVotes, ACompanionThatJoinsOrLeavesMovesTheBar) {
  for (const ClientId id : {1u, 2u}) join(id, "P");
  vote(1);
  EXPECT_EQ(counts(), (std::vector<VoteCount>{{1, 1, 2}}));
  add(2, 1, "Q");
  run(VoteNotices::kMinTicks);
  EXPECT_EQ(sentTo<VoteCount>(1), (std::vector<VoteCount>{{1, 1, 3}}));
  drop(2, 1);
  add(1, 1, "Q");
  run();
  EXPECT_EQ(sentTo<RoundEnd>(1).size(), 1u) << "2 of 3";
}

TEST_F(CompanionVotes, AnInactiveCompanionIsNoVoterAndItsConnectionHasNoVoteForIt) {
  join(1, "Ann");
  add(1, 1, "Ben");
  join(2, "Cid");
  run(MatchPlayer::kActiveTicks - 1);
  press(1, Input::kLeft, {});
  press(2, Input::kLeft, {});
  run(10);
  forget();
  vote(1);
  EXPECT_EQ(counts(), (std::vector<VoteCount>{{1, 1, 2}})) << "Ben is inactive";
}

TEST_F(CompanionVotes, AWishIsTakenBackForAll) {
  join(1, "Ann");
  add(1, 1, "Ben");
  for (const ClientId id : {2u, 3u}) join(id, "P");
  vote(1);
  EXPECT_EQ(counts(), (std::vector<VoteCount>{{1, 2, 4}}));
  vote(1, false);
  run(VoteWish::kMinTicks);
  EXPECT_EQ(sentTo<VoteCount>(1), (std::vector<VoteCount>{{1, 0, 0}}));
}

// A match in a network of virtual time.
class CompanionPlay : public testing::Test {
 protected:
  static Match matchOn(const std::string& text, const MatchSettings& settings = {.maxPlayers = 8}) {
    return Match(LevelRotation({levelOf(text)}), settings);
  }
  static FakeClientNetwork networkOn(const std::string& text, const MatchSettings& settings = {.maxPlayers = 8}) {
    return FakeClientNetwork(matchOn(text, settings), {.delayMs = kTickMs});
  }
  static void expectInLockstep(FakeClientNetwork& network, ClientId id) {
    const FakeClient& client = network.client(id);
    EXPECT_EQ(client.desyncs(), 0u) << id;
    ASSERT_FALSE(client.hashes().empty()) << id;
    for (const auto& [tick, hash] : client.hashes()) {
      ASSERT_EQ(hash, network.hashOf(client.round(), tick)) << "client " << id << " tick " << tick;
    }
  }
};

// Each presses something else.
TEST_F(CompanionPlay, FourPlayersOfAConnectionPlayEachByItsOwnInputsUnderLoss) {
  FakeClientNetwork network(matchOn(farGoalText()),
                            {.lossPercent = 20, .delayMs = 4 * kTickMs, .jitterMs = 4 * kTickMs, .reorderPercent = 20},
                            4);
  const auto buttons = [](std::uint32_t local) {
    return [local](std::uint32_t tick) { return static_cast<int>((tick / (5 + local) + local) % 8); };
  };
  FakeClient& client = network.add(FakeClient("A", 30, buttons(0)));
  network.add(FakeClient("Far", 30, running));
  for (const std::uint32_t local : {1u, 2u, 3u}) client.addCompanion(local, "P", buttons(local));
  network.run(500);
  for (std::uint32_t local = 0; local < kMaxLocalPlayers; ++local) {
    ASSERT_TRUE(client.slot(local)) << local;
    std::uint32_t compared = 0;
    for (const auto& [tick, input] : client.decided(local)) {
      if (tick < 60) continue;
      const auto pressed = static_cast<std::uint8_t>(buttons(local)(tick) | Input::kPresent);
      ASSERT_EQ(input, validInput(pressed)) << "local number " << local << " tick " << tick;
      ++compared;
    }
    EXPECT_GT(compared, 400u);
  }
  for (const ClientId id : {1u, 2u}) expectInLockstep(network, id);
  EXPECT_EQ(network.match().missedInputs(), 0u);
  EXPECT_EQ(network.count(Kind::kDesync), 0u);
}

TEST_F(CompanionPlay, TheRoundWaitsForACompanionThatIsActive) {
  FakeClientNetwork network = networkOn(shortWayText());
  FakeClient& client = network.add(FakeClient("Ann", 12, running));
  client.addCompanion(1, "Ben", [](std::uint32_t tick) { return tick < 400 ? static_cast<int>(tick / 8 % 2) : 2; });
  network.run(390);
  EXPECT_TRUE(network.match().game().player(0).finished());
  EXPECT_EQ(network.count(Kind::kRoundEnd), 0u);
  network.run(210);
  EXPECT_TRUE(network.match().game().player(1).finished());
  EXPECT_EQ(network.count(Kind::kRoundEnd), 1u);
}

TEST_F(CompanionPlay, TheNextRoundIsPlayedByAllOfThem) {
  FakeClientNetwork network = networkOn(shortWayText());
  FakeClient& client = network.add(FakeClient("Ann", 12, running));
  client.addCompanion(1, "Ben", running);
  network.run(200);
  ASSERT_EQ(network.count(Kind::kRoundEnd), 1u);
  network.run(MatchRounds::kPauseTicks);
  ASSERT_EQ(network.match().round(), 2u);
  for (const std::uint32_t slot : {0u, 1u}) EXPECT_TRUE(network.match().game().player(slot).present) << slot;
  EXPECT_EQ(client.slot(1), 1u);
  expectInLockstep(network, 1);
}

TEST_F(CompanionPlay, TwoAtOneMachineHaveNoTimeLimitAndAskForTheNextRound) {
  FakeClientNetwork network = networkOn(shortWayText(), {.maxPlayers = 4, .waitsForOne = true});
  FakeClient& client = network.add(FakeClient("Ann", 12, idle));
  client.addCompanion(1, "Ben", idle);
  network.run(kRoundTicks + 600);
  EXPECT_TRUE(network.match().waits());
  EXPECT_TRUE(network.match().game().over()) << "its own clock has run out";
  EXPECT_EQ(network.count(Kind::kRoundEnd), 0u);
  network.match().endRoundNow();
  network.run(2 * MatchRounds::kPauseTicks);
  ASSERT_TRUE(client.roundEnd());
  EXPECT_EQ(client.roundEnd()->pauseTicks, 0u);
  EXPECT_EQ(network.match().round(), 1u);
  network.add(FakeClient("Far", 12, idle));
  network.run(MatchRounds::kPauseTicks + 10);
  EXPECT_FALSE(network.match().waits());
  EXPECT_EQ(network.match().round(), 2u) << "with another machine, the pause ends";
}

TEST_F(CompanionPlay, ATimeOfTwoAtOneMachineDoesNotLastOnALevelForOne) {
  KeptTimes times;
  FakeClientNetwork network(
      Match(LevelRotation({levelOf(shortWayText())}), {.maxPlayers = 4, .waitsForOne = true, .keepsTimesOfOne = true},
            {.bestTimes = &times}),
      {.delayMs = kTickMs});
  network.match().keepTimesOf({0});
  network.add(FakeClient("Ann", 12, running)).addCompanion(1, "Ben", idle);
  network.run(200);
  EXPECT_EQ(times.offered.size(), 1u);
  EXPECT_TRUE(times.lasting.empty());
}

TEST_F(CompanionPlay, ALevelForTwoBeginsAnewWhenTheCompanionJoins) {
  FakeClientNetwork network = networkOn("# players: 2\n" + shortWayText(), {.maxPlayers = 4, .waitsForOne = true});
  FakeClient& client = network.add(FakeClient("Ann", 12, idle));
  network.run(300);
  EXPECT_EQ(network.match().round(), 1u);
  client.addCompanion(1, "Ben", idle);
  network.run(60);
  EXPECT_EQ(network.match().round(), 2u);
  EXPECT_TRUE(network.match().game().player(1).present);
  client.addCompanion(2, "Cid", idle);
  network.run(60);
  EXPECT_EQ(network.match().round(), 2u) << "enough were there";
  expectInLockstep(network, 1);
}

TEST_F(CompanionPlay, ALevelForTwoIsNextForTwoPlayersOfAConnection) {
  const LevelPointer one = levelOf(shortWayText());
  const LevelPointer two = levelOf("# players: 2\n" + shortWayText());
  FakeClientNetwork network(Match(LevelRotation({one, two}), {.maxPlayers = 4}), {.delayMs = kTickMs});
  FakeClient& client = network.add(FakeClient("Ann", 12, idle));
  client.addCompanion(1, "Ben", idle);
  network.run(10);
  network.match().endRoundNow();
  network.run(2);
  EXPECT_EQ(client.roundEnd()->nextLevelHash, two->hash);
  client.removeCompanion(1);
  network.run(4);
  EXPECT_EQ(client.roundEnd()->nextLevelHash, one->hash);
}

class CompanionResume : public CompanionPlay {
 protected:
  CompanionResume() {
    FakeClient& client = network_.add(FakeClient("Ann", 12, running));
    network_.add(FakeClient("Ben", 12, idle));
    network_.run(3);
    client.addCompanion(1, "Cid", running);
    client.addCompanion(3, "Dan", idle);
    network_.run(60);
  }

  FakeClient& resume(ClientId id) {
    FakeClient& client = network_.add(FakeClient(network_.client(id), idle));
    network_.run(40);
    return client;
  }

  FakeClientNetwork network_ = networkOn(farGoalText());
};

TEST_F(CompanionResume, ATokenResumesAllPlayersInTheirSlots) {
  const SlotsByLocal before{0, 2, kNone, 3};
  ASSERT_EQ(network_.client(1).localSlots().back().slots, before);
  network_.disconnect(1);
  network_.run(100);
  for (const std::uint32_t slot : {0u, 2u, 3u}) EXPECT_TRUE(network_.match().game().player(slot).present) << slot;
  EXPECT_EQ(network_.match().players(), 1u);
  EXPECT_EQ(network_.match().allPlayers(), 4u);
  const FakeClient& resumed = resume(1);
  EXPECT_EQ(resumed.welcome()->slot, 0u);
  ASSERT_EQ(resumed.localSlots(), (std::vector<LocalSlots>{{before}}));
  EXPECT_EQ(resumed.decided(1).rbegin()->second, (Input{Input::kPresent | Input::kRight}));
  EXPECT_EQ(network_.count(Kind::kConnectionLost), 3u);
  EXPECT_EQ(network_.count(Kind::kResumed), 3u);
  EXPECT_EQ(network_.count(Kind::kLeft), 0u);
  EXPECT_EQ(network_.client(2).roster().at(2), "Cid");
  for (const ClientId id : {2u, 3u}) expectInLockstep(network_, id);
}

TEST_F(CompanionResume, WhoResumesAloneIsToldNoSlots) {
  network_.client(1).removeCompanion(1);
  network_.client(1).removeCompanion(3);
  network_.run(10);
  network_.disconnect(1);
  network_.run(10);
  EXPECT_TRUE(resume(1).localSlots().empty());
}

TEST_F(CompanionResume, AnOpenConnectionIsResumedWithAllPlayers) {
  const FakeClient& resumed = resume(1);
  EXPECT_EQ(resumed.localSlots(), (std::vector<LocalSlots>{{{0, 2, kNone, 3}}}));
  ASSERT_TRUE(network_.client(1).bye());
  EXPECT_FALSE(network_.match().isPlaying(1));
  network_.match().disconnect(1);
  network_.run(20);
  EXPECT_EQ(network_.match().players(), 4u);
  network_.client(3).removeCompanion(3);
  network_.run(20);
  EXPECT_EQ(network_.match().players(), 3u);
}

TEST_F(CompanionResume, AllExpireTogetherAfterAMinute) {
  network_.disconnect(1);
  network_.run(MatchRoster::kResumeTicks - 1);
  EXPECT_EQ(network_.match().allPlayers(), 4u);
  network_.run(5);
  EXPECT_EQ(network_.match().allPlayers(), 1u);
  EXPECT_EQ(network_.count(Kind::kLeft), 3u);
  for (const std::uint32_t slot : {0u, 2u, 3u}) EXPECT_FALSE(network_.match().game().player(slot).present) << slot;
  EXPECT_TRUE(resume(1).localSlots().empty()) << "it has joined as another player";
}

TEST_F(CompanionResume, AConnectionWithoutATokenLeavesWithAllPlayers) {
  Match match = matchOn(farGoalText());
  match.receive(1, Hello{});
  match.receive(1, Companion{1, true, "Ben"});
  EXPECT_EQ(match.players(), 2u);
  match.disconnect(1);
  EXPECT_TRUE(match.idle());
}

class CompanionKick : public CompanionTest {
 protected:
  CompanionKick() {
    join(1, "Ann");
    join(2, "Ben");
    add(1, 1, "Cid");
    add(1, 2, "Dan");
    forget();
  }
  static constexpr const char* kForbidden =
      "a player was removed from your connection, so nobody else can join over it: leave and join again";
};

TEST_F(CompanionKick, ACompanionGoesAlone) {
  EXPECT_TRUE(match_.kick(2, "too loud"));
  const std::span<const Outgoing> sent = match_.takeOutgoing();
  ASSERT_EQ(sent.size(), 1u);
  EXPECT_EQ(sent[0].client, 1u);
  EXPECT_FALSE(sent[0].last) << "the connection stays";
  EXPECT_EQ(decodeToClient(sent[0].bytes), ToClient(LocalSlots{{0, kNone, 3}, "Cid: too loud"}));
  EXPECT_EQ(events(), (Texts{"left 1 2 Cid"}));
  EXPECT_EQ(names(), (Names{{0, "Ann"}, {1, "Ben"}, {3, "Dan"}}));
}

TEST_F(CompanionKick, TheFirstPlayerGoesWithAllAndTheConnectionEnds) {
  EXPECT_TRUE(match_.kick(0, "too loud"));
  EXPECT_EQ(events(), (Texts{"left 1 0 Ann", "left 1 2 Cid", "left 1 3 Dan"}));
  EXPECT_EQ(sentTo<Bye>(1), (std::vector<Bye>{{ByeCode::kRemoved, "too loud"}}));
  EXPECT_FALSE(match_.isPlaying(1));
}

// It would be back at once.
TEST_F(CompanionKick, NobodyElseJoinsOverTheConnectionOfOneThatWasKicked) {
  match_.kick(2, "too loud");
  rest();
  EXPECT_EQ(add(1, 1, "Cid"), (LocalSlots{{0, kNone, 3}, kForbidden}));
  EXPECT_EQ(add(1, 3, "Eve"), (LocalSlots{{0, kNone, 3}, kForbidden}));
  EXPECT_EQ(add(1, 2, "Eve"), (LocalSlots{{0, kNone, 3}})) << "who is there may have another name";
  EXPECT_EQ(drop(1, 2), (LocalSlots{{0}}));
  EXPECT_EQ(add(2, 1, "Cid"), (LocalSlots{{1, 2}})) << "over another connection it may";
}

TEST_F(CompanionKick, ResumingDoesNotHelp) {
  match_.kick(2, "too loud");
  match_.disconnect(1);
  match_.receive(7, helloOf("Ann", 1));
  EXPECT_EQ(sentTo<LocalSlots>(7), (std::vector<LocalSlots>{{{0, kNone, 3}}}));
  rest();
  EXPECT_EQ(add(7, 1, "Cid"), (LocalSlots{{0, kNone, 3}, kForbidden}));
}

TEST_F(CompanionKick, ANewConnectionMayHaveCompanions) {
  match_.kick(2, "too loud");
  match_.receive(1, Leave{});
  run();
  join(7, "Ann");
  EXPECT_EQ(add(7, 1, "Cid").reason, "");
}

TEST_F(CompanionKick, WhileDisconnectedItGoesAloneToo) {
  match_.disconnect(1);
  events();
  EXPECT_TRUE(match_.kick(3, "too loud"));
  EXPECT_FALSE(match_.kick(3, "too loud")) << "it has gone";
  EXPECT_EQ(events(), (Texts{"left 0 3 Dan"}));
  match_.receive(7, helloOf("Ann", 1));
  EXPECT_EQ(sentTo<LocalSlots>(7), (std::vector<LocalSlots>{{{0, 2}}}));
  rest();
  EXPECT_EQ(add(7, 2, "Dan"), (LocalSlots{{0, 2}, kForbidden}));
}

TEST_F(CompanionKick, TheFirstPlayerThatIsDisconnectedGoesWithAll) {
  match_.disconnect(1);
  events();
  EXPECT_TRUE(match_.kick(0, "too loud"));
  EXPECT_EQ(events(), (Texts{"left 0 0 Ann", "left 0 2 Cid", "left 0 3 Dan"}));
  EXPECT_EQ(match_.allPlayers(), 1u);
}

}  // namespace
}  // namespace platon::match_companions_test
