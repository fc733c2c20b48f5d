// Who misuses that several players may share a connection.
#include "tests/server/match/companion_fixture.h"

namespace platon::hostile_companions_test {
namespace {

using Names = std::map<std::uint32_t, std::string>;
using Texts = std::vector<std::string>;

constexpr auto kNone = std::nullopt;
constexpr const char* kTooMany = "a connection may have at most 4 players";
constexpr const char* kTooOften = "players join here too often: wait two seconds";
constexpr const char* kHouseholdFull = "your address already has 4 players, which is all that this server allows";

class HostileCompanions : public CompanionTest {};

TEST_F(HostileCompanions, NobodyHasCompanionsBeforeHello) {
  match_.receive(1, Companion{1, true, "Eve"});
  match_.receive(1, Companion{1, false});
  match_.receive(1, LocalChat{1, {"a", 0}});
  EXPECT_TRUE(match_.takeOutgoing().empty());
  EXPECT_TRUE(match_.idle());
}

TEST_F(HostileCompanions, ALocalNumberBeyondTheLastIsRefused) {
  join(1, "Ann");
  for (const std::uint32_t local : {4u, 255u}) {
    EXPECT_EQ(add(1, local, "Eve"), (LocalSlots{{0}, kTooMany})) << local;
    EXPECT_EQ(drop(1, local), (LocalSlots{{0}, kTooMany})) << local;
  }
  rest();
  EXPECT_EQ(add(1, UINT32_MAX, "Eve"), (LocalSlots{{0}, kTooMany}));
  EXPECT_EQ(names(), (Names{{0, "Ann"}}));
}

TEST_F(HostileCompanions, OneThatJoinsTwiceHasOneSlot) {
  join(1, "Ann");
  EXPECT_EQ(add(1, 1, "Eve"), (LocalSlots{{0, 1}}));
  EXPECT_EQ(add(1, 1, "Eve"), (LocalSlots{{0, 1}}));
  EXPECT_EQ(events(), (Texts{"joined 1 1 Eve"}));
  EXPECT_EQ(match_.players(), 2u);
}

TEST_F(HostileCompanions, OneThatLeavesTwiceLeavesOnce) {
  join(1, "Ann");
  add(1, 1, "Eve");
  events();
  EXPECT_EQ(drop(1, 1), (LocalSlots{{0}}));
  EXPECT_EQ(drop(1, 1), (LocalSlots{{0}}));
  EXPECT_EQ(drop(1, 3), (LocalSlots{{0}}));
  EXPECT_EQ(events(), (Texts{"left 1 1 Eve"}));
}

TEST_F(HostileCompanions, InputsOfOneThatHasLeftAreIgnored) {
  join(1, "Ann");
  add(1, 1, "Eve");
  press(1, Input::kLeft, {1});
  run();
  ASSERT_TRUE(isPresent(1));
  drop(1, 1);
  for (int tick = 0; tick < 10; ++tick) {
    press(1, Input::kRight, {1, 2, 3});
    run();
    EXPECT_FALSE(isPresent(1)) << tick;
  }
  EXPECT_EQ(match_.game().slots(), 2u);
  EXPECT_EQ(match_.missedInputs(), 0u);
}

TEST_F(HostileCompanions, InputsForNoPlayerMoveNoneOfAnotherConnection) {
  join(1, "Ann");
  join(2, "Ben");
  press(1, 0, {1, 2, 3});
  press(2, 0, {});
  run();
  press(1, Input::kRight, {1, 2, 3});
  run(5);
  EXPECT_NE(match_.game().player(0).velocity.x, 0);
  EXPECT_EQ(match_.game().player(1).velocity.x, 0);
  EXPECT_EQ(match_.game().slots(), 2u);
}

TEST_F(HostileCompanions, NamesAreThoseOfHello) {
  join(1, std::string(kMaxNameBytes, 'x'));
  const std::string longest(kMaxNameBytes, 'x');
  add(1, 1, longest);
  add(1, 2, "\u0301\u0302\u0303");
  add(1, 3, "\u200b \u3164");
  EXPECT_EQ(names(),
            (Names{{0, longest}, {1, longest.substr(0, kMaxNameBytes - 2) + " 2"}, {2, "Player 3"}, {3, "Player 4"}}));
}

TEST_F(HostileCompanions, NobodyTakesTheNameOfAMutedPlayerOrItsNumber) {
  join(1, "Ann");
  join(2, "Eve");
  match_.mute(1, true);
  add(1, 1, "Eve");
  add(1, 2, "Player 2");
  EXPECT_EQ(names().at(2), "Eve 2");
  EXPECT_EQ(names().at(3), "Player 2 2");
}

TEST_F(HostileCompanions, TooManyWishesAreRefusedAndChangeNothing) {
  join(1, "Ann");
  for (int i = 0; i < 4; ++i) EXPECT_EQ(add(1, 1, "Eve " + std::to_string(i)).reason, "");
  EXPECT_EQ(add(1, 1, "Ben"), (LocalSlots{{0, 1}, kTooOften}));
  run();
  EXPECT_EQ(add(1, 2, "Ben"), (LocalSlots{{0, 1}, kTooOften}));
  run();
  EXPECT_EQ(drop(1, 2), (LocalSlots{{0, 1}, kTooOften})) << "nobody leaves";
  EXPECT_EQ(names(), (Names{{0, "Ann"}, {1, "Eve 3"}}));
  EXPECT_EQ(drop(1, 1), (LocalSlots{{0}})) << "who plays may leave";
  run(2 * kTicksPerSecond);
  EXPECT_EQ(add(1, 2, "Ben").reason, "");
}

TEST_F(HostileCompanions, AFloodGetsOneRefusalATickOfEachNumberAndTheOthersTheNamesOfFew) {
  join(1, "Ann");
  join(2, "Ben");
  rest();
  std::size_t refusals = 0;
  std::size_t rosters = 0;
  constexpr int kSeconds = 10;
  for (int tick = 0; tick < kSeconds * kTicksPerSecond; ++tick) {
    for (int i = 0; i < 20; ++i) {
      const auto local = static_cast<std::uint32_t>(1 + (tick + i) % 5);
      const bool joins = (tick / 7 + i) % 2 == 0;
      match_.receive(1, Companion{local, joins, joins ? "Eve " + std::to_string(tick + i) : ""});
    }
    run();
    for (const Outgoing& sent : match_.takeOutgoing()) {
      const auto message = decodeToClient(sent.bytes);
      const auto* slots = std::get_if<LocalSlots>(&*message);
      refusals += slots && slots->reason == kTooOften ? 1 : 0;
      rosters += sent.client == 2 && std::holds_alternative<Roster>(*message) ? 1 : 0;
    }
  }
  const std::size_t allowed = 4 + kSeconds / 2;
  EXPECT_LE(events().size(), 2 * allowed) << "who joins may leave";
  EXPECT_LE(rosters, 2 * allowed);
  EXPECT_LE(refusals, std::size_t{kMaxLocalPlayers * kSeconds * kTicksPerSecond});
  EXPECT_GT(refusals, 0u);
}

TEST_F(HostileCompanions, OneConnectionsWishesTakeNothingFromAnother) {
  join(1, "Ann");
  join(2, "Ben");
  for (int i = 0; i < 100; ++i) match_.receive(1, Companion{1, true, "Eve"});
  EXPECT_EQ(add(2, 1, "Cid").reason, "");
}

TEST_F(HostileCompanions, ResumingGivesNoNewBudget) {
  join(1, "Ann");
  for (int i = 0; i < 4; ++i) add(1, 1, "Eve " + std::to_string(i));
  match_.receive(2, helloOf("Ann", 1));
  EXPECT_EQ(add(2, 2, "Ben").reason, kTooOften);
}

// A client that resumed twice was told that its players join too often.
TEST_F(HostileCompanions, NamesThatAreSaidAgainCostNothing) {
  join(1, "Ann");
  for (const std::uint32_t local : {1u, 2u, 3u}) add(1, local, "Eve");
  rest();
  for (ClientId id = 2; id < 12; ++id) {
    match_.receive(id, helloOf("Ann", 1));
    forget();
    for (const std::uint32_t local : {1u, 2u, 3u}) EXPECT_EQ(add(id, local, "Eve"), (LocalSlots{{0, 1, 2, 3}}));
    run();
  }
  EXPECT_EQ(names(), (Names{{0, "Ann"}, {1, "Eve"}, {2, "Eve 2"}, {3, "Eve 3"}}));
  for (int i = 0; i < 4; ++i) EXPECT_EQ(add(11, 1, "Cid " + std::to_string(i)).reason, "");
  EXPECT_EQ(add(11, 1, "Dan").reason, kTooOften) << "another name is a change";
}

TEST_F(HostileCompanions, OneTickHasOneAnswerToANameThatIsSaidAgain) {
  join(1, "Ann");
  add(1, 1, "Eve");
  run();
  forget();
  for (int i = 0; i < 100; ++i) match_.receive(1, Companion{1, true, "Eve"});
  EXPECT_EQ(sentTo<LocalSlots>(1).size(), 1u);
}

TEST_F(HostileCompanions, AConnectionThatWasResumedElsewhereHasNoCompanions) {
  join(1, "Ann");
  add(1, 1, "Eve");
  match_.receive(2, helloOf("Ann", 1));
  match_.takeOutgoing();
  match_.receive(1, Companion{2, true, "Mallory"});
  match_.receive(1, Companion{1, false});
  match_.receive(1, LocalChat{1, {"a", 0}});
  EXPECT_TRUE(match_.takeOutgoing().empty());
  EXPECT_EQ(match_.find(2)->slots(), (SlotsByLocal{0, 1}));
}

// Two slots of one connection and a name that is already there.
TEST_F(HostileCompanions, TwoCompanionsOfOneNameSwapNothing) {
  join(1, "Ann");
  add(1, 1, "Eve");
  add(1, 2, "Eve");
  EXPECT_EQ(names(), (Names{{0, "Ann"}, {1, "Eve"}, {2, "Eve 2"}}));
  drop(1, 1);
  EXPECT_EQ(add(1, 2, "Eve"), (LocalSlots{{0, kNone, 2}}));
  EXPECT_EQ(names(), (Names{{0, "Ann"}, {2, "Eve 2"}})) << "a name that is said again stays";
}

class FullHousehold : public CompanionTest {
 protected:
  FullHousehold() : CompanionTest({.maxPlayers = 16, .playersPerOrigin = 4}) {}
};

TEST_F(FullHousehold, CompanionsCount) {
  join(1, "Ann", 7);
  join(2, "Ben", 7);
  EXPECT_EQ(add(1, 1, "Cid").reason, "");
  EXPECT_EQ(add(2, 1, "Dan").reason, "");
  events();
  EXPECT_EQ(add(1, 2, "Eve"), (LocalSlots{{0, 2}, kHouseholdFull}));
  EXPECT_EQ(events(), Texts{});
  join(3, "Fay", 7);
  EXPECT_FALSE(match_.isPlaying(3));
  EXPECT_EQ(drop(2, 1).reason, "");
  EXPECT_EQ(add(1, 2, "Eve").reason, "");
}

TEST_F(FullHousehold, AnotherHouseholdHasItsOwnRoom) {
  join(1, "Ann", 7);
  for (const std::uint32_t local : {1u, 2u, 3u}) add(1, local, "P");
  join(2, "Ben", 8);
  EXPECT_EQ(add(2, 1, "Cid").reason, "");
}

TEST_F(FullHousehold, ThisMachineHasRoomForAnyNumber) {
  for (const ClientId id : {1u, 2u}) {
    join(id, "P");
    for (const std::uint32_t local : {1u, 2u, 3u}) EXPECT_EQ(add(id, local, "P").reason, "");
  }
  EXPECT_EQ(match_.players(), 8u);
  match_.receive(3, helloOf("P", 1));
  EXPECT_EQ(sentTo<LocalSlots>(3).size(), 1u) << "and for four who resume";
}

// As a newcomer.
TEST_F(FullHousehold, ACompanionTakesThePlaceOfThoseThatAreDisconnectedLongest) {
  join(1, "Ann", 7);
  add(1, 1, "Ben");
  join(2, "Cid", 7);
  join(3, "Dan", 7);
  match_.disconnect(1);
  match_.disconnect(2);
  events();
  EXPECT_EQ(add(3, 1, "Eve").reason, "");
  EXPECT_EQ(events(), (Texts{"joined 3 4 Eve", "left 0 0 Ann", "left 0 1 Ben"})) << "they expire together";
  EXPECT_EQ(add(3, 2, "Fay").reason, "");
  EXPECT_EQ(events(), (Texts{"joined 3 0 Fay"})) << "there is room";
}

TEST_F(FullHousehold, ACompanionThatFindsNoSlotDisplacesNobody) {
  match_ = Match(LevelRotation({levelOf(farGoalText())}), {.maxPlayers = 3, .playersPerOrigin = 3});
  join(1, "Ann", 7);
  join(2, "Ben", 7);
  join(3, "Cid", 7);
  match_.disconnect(1);
  events();
  EXPECT_EQ(add(2, 1, "Eve").reason, "the server is full (3 players): try again later");
  EXPECT_EQ(events(), Texts{});
  EXPECT_EQ(match_.allPlayers(), 3u);
}

TEST_F(FullHousehold, AConnectionMovesOnlyWhereAllItsPlayersHaveRoom) {
  join(1, "Ann", 7);
  add(1, 1, "Ben");
  join(2, "Cid", 8);
  add(2, 1, "Dan");
  add(2, 2, "Eve");
  EXPECT_FALSE(match_.move(1, addressOf(8)));
  EXPECT_EQ(match_.find(1)->address(), addressOf(7));
  EXPECT_TRUE(match_.move(2, addressOf(8))) << "it is there already";
  drop(2, 2);
  EXPECT_TRUE(match_.move(1, addressOf(8)));
  EXPECT_EQ(match_.players(), 4u);
  EXPECT_EQ(add(1, 2, "Fay").reason, kHouseholdFull) << "it counts where it is";
}

TEST_F(FullHousehold, AConnectionResumesOnlyWhereAllItsPlayersHaveRoom) {
  join(1, "Ann", 7);
  for (const std::uint32_t local : {1u, 2u}) add(1, local, "P");
  join(2, "Ben", 8);
  add(2, 1, "Cid");
  match_.disconnect(1);
  forget();
  match_.receive(3, helloOf("Ann", 1), addressOf(8));
  EXPECT_FALSE(match_.isPlaying(3));
  EXPECT_EQ(sentTo<Refused>(3),
            (std::vector<Refused>{
                {RefusalCode::kFull, "your address has no room for your 3 players: this server allows 4 there"}}));
  match_.receive(4, helloOf("Ann", 1), addressOf(7));
  EXPECT_EQ(sentTo<LocalSlots>(4), (std::vector<LocalSlots>{{{0, 1, 2}}}));
}

// As with as many connections: two households that move and resume each other's players fill no server.
TEST_F(FullHousehold, TwoHouseholdsThatResumeEachOthersPlayersHoldNoMoreThanTwoMay) {
  for (std::uint32_t cycle = 0; cycle < 16; ++cycle) {
    const ClientId id = 1 + 2 * cycle;
    const Hello hello = helloOf("P", static_cast<std::uint8_t>(1 + cycle));
    match_.receive(id, hello, addressOf(1));
    for (const std::uint32_t local : {1u, 2u}) match_.receive(id, Companion{local, true, "Q"});
    match_.receive(id + 1, hello, addressOf(2));
    match_.disconnect(id + 1);
    run();
    EXPECT_LE(match_.allPlayers(), 8u);
  }
  join(99, "Ann", 3);
  EXPECT_TRUE(match_.isPlaying(99));
}

TEST_F(FullHousehold, CompanionsThatJoinAgainAndAgainSayNoMoreThanTheirHouseholdMay) {
  join(1, "Eve", 7);
  join(2, "Ann", 8);
  rest();
  std::size_t heard = 0;
  constexpr std::uint32_t kTicks = 40 * kTicksPerSecond;
  for (std::uint32_t tick = 0; tick < kTicks; ++tick) {
    const std::uint32_t local = 1 + tick % 3;
    match_.receive(1, Companion{local, true, "P"});
    for (int i = 0; i < 4; ++i) match_.receive(1, LocalChat{local, {"", 1}});
    match_.receive(1, Companion{local, false});
    run();
    heard += sentTo<PlayerChat>(2).size();
  }
  EXPECT_LE(heard, 16u + 2 * 40) << "what four players may say";
  EXPECT_GT(heard, 0u);
}

}  // namespace
}  // namespace platon::hostile_companions_test
