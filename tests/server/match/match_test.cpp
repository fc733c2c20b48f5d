#include "server/match/match.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "tests/net/support/fake_client.h"
#include "tests/net/support/fake_client_network.h"
#include "tests/support/test_levels.h"

namespace platon::match_test {
namespace {

using Kind = MatchEvent::Kind;

Match matchOn(const std::string& text, std::uint32_t maxPlayers = 8) {
  return Match(LevelRotation({levelOf(text)}), {maxPlayers, "Test"});
}

Input pressing(int buttons) { return Input{static_cast<std::uint8_t>(buttons | Input::kPresent)}; }

// Buttons that change every few ticks, in a different way for each seed.
std::function<int(std::uint32_t)> busy(std::uint32_t seed) {
  return [seed](std::uint32_t tick) { return static_cast<int>((tick / (5 + seed) * 2654435761u + seed) >> 28) & 7; };
}

FakeClient player(const std::string& name, std::uint32_t lead = 8, std::uint32_t seed = 1) {
  return FakeClient(name, lead, busy(seed));
}

void expectInLockstep(FakeClientNetwork& network, ClientId client) {
  SCOPED_TRACE("client " + std::to_string(client));
  const FakeClient& fake = network.client(client);
  EXPECT_EQ(fake.desyncs(), 0u);
  EXPECT_EQ(fake.round(), network.match().round());
  ASSERT_FALSE(fake.hashes().empty());
  for (const auto& [tick, hash] : fake.hashes()) ASSERT_EQ(hash, network.hashOf(fake.round(), tick)) << "tick " << tick;
}

TEST(Match, SendsWelcomeAndTheNamesOfAllPlayers) {
  FakeClientNetwork network(matchOn(farGoalText()));
  network.add(player("Ann"));
  network.run(5);
  network.add(player(""));
  network.run(MatchUpdates::kNamesTicks);
  const auto welcome = network.client(2).welcome();
  ASSERT_TRUE(welcome);
  EXPECT_EQ(welcome->slot, 1u);
  EXPECT_EQ(welcome->maxPlayers, 8u);
  EXPECT_EQ(welcome->serverName, "Test");
  EXPECT_EQ(welcome->levelHash, levelOf(farGoalText())->hash);
  const std::map<std::uint32_t, std::string> roster{{0, "Ann"}, {1, "Player 2"}};
  EXPECT_EQ(network.client(1).roster(), roster);
  EXPECT_EQ(network.client(2).roster(), roster);
  network.leave(2);
  network.run(MatchUpdates::kNamesTicks);
  EXPECT_EQ(network.client(1).roster().at(1), "");
}

TEST(Match, RefusesAClientWithAReason) {
  Match match = matchOn(farGoalText(), 1);
  const auto answer = [&match](ClientId client, const Hello& hello) {
    match.receive(client, hello);
    const std::span<const Outgoing> sent = match.takeOutgoing();
    EXPECT_EQ(sent.size(), 1u);
    EXPECT_TRUE(sent[0].reliable && sent[0].last);
    EXPECT_FALSE(match.isPlaying(client));
    return std::get<Refused>(*decodeToClient(sent[0].bytes));
  };
  const Refused rules = answer(2, {kRulesVersion - 1, ""});
  EXPECT_EQ(rules.code, RefusalCode::kWrongRules);
  EXPECT_TRUE(rules.reason.ends_with(": update your client")) << rules.reason;
  match.receive(3, Hello{});
  match.takeOutgoing();
  EXPECT_EQ(answer(4, Hello{}).code, RefusalCode::kFull);
}

TEST(Match, IgnoresAllMessagesBeforeHello) {
  Match match = matchOn(farGoalText());
  match.receive(1, LevelRequest{levelOf(farGoalText())->hash});
  match.receive(1, PlayerInputs{1, 0, 0, 0, 0, {Input{Input::kPresent}}});
  match.receive(1, Leave{});
  match.tick();
  EXPECT_TRUE(match.idle());
  EXPECT_TRUE(match.takeOutgoing().empty());
  EXPECT_EQ(match.game().tick(), 0u);
}

TEST(Match, AllClientsPlayTheSameGame) {
  FakeClientNetwork network(matchOn(farGoalText()));
  for (std::uint32_t i = 0; i < 6; ++i) network.add(player("P", 8, i));
  network.run(600);
  for (ClientId client = 1; client <= 6; ++client) {
    expectInLockstep(network, client);
    EXPECT_GE(network.client(client).confirmed() + 4, network.match().game().tick());
    EXPECT_EQ(network.client(client).states(), 0u);
    for (const auto& [tick, input] : network.client(client).decided()) {
      if (tick < 20) continue;
      ASSERT_EQ(input, validInput(static_cast<std::uint8_t>(busy(client - 1)(tick) | Input::kPresent))) << tick;
    }
  }
  EXPECT_EQ(network.match().game().slots(), 6u);
}

TEST(Match, ClientsStayInLockstepUnderLossDelayAndReordering) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    FakeClientNetwork network(
        matchOn(farGoalText()),
        {.lossPercent = 25, .delayMs = 4 * kTickMs, .jitterMs = 6 * kTickMs, .reorderPercent = 30}, seed);
    for (std::uint32_t i = 0; i < 5; ++i) network.add(player("P", 30, i));
    network.run(500);
    for (ClientId client = 1; client <= 5; ++client) {
      expectInLockstep(network, client);
      EXPECT_GE(network.client(client).confirmed() + 40, network.match().game().tick());
    }
    EXPECT_EQ(network.count(Kind::kDesync), 0u);
    EXPECT_LE(network.longest(), kMaxMessageBytes);
  }
}

// More changes are unacknowledged than one message holds.
TEST(Match, ChangesThatExceedOneMessageAreSentInParts) {
  FakeClientNetwork network(matchOn(farGoalText(), 12),
                            {.lossPercent = 2, .delayMs = 30 * kTickMs, .jitterMs = 2 * kTickMs, .reorderPercent = 30},
                            6);
  for (std::uint32_t i = 0; i < 12; ++i) {
    network.add(FakeClient("P", 80, [i](std::uint32_t tick) { return static_cast<int>((tick + i) % 2); }));
  }
  network.run(300);
  EXPECT_GT(network.longest(), kMaxMessageBytes * 8 / 10);
  for (ClientId client = 1; client <= 12; ++client) {
    expectInLockstep(network, client);
    EXPECT_GE(network.client(client).confirmed() + 60, network.match().game().tick());
  }
}

TEST(Match, WorksAtARoundTripOfTwoSeconds) {
  FakeClientNetwork network(matchOn(farGoalText()), {.lossPercent = 5, .delayMs = 60 * kTickMs}, 5);
  network.add(player("Far", 130));
  network.run(1200);
  expectInLockstep(network, 1);
  EXPECT_EQ(network.client(1).states(), 0u);
  EXPECT_GE(network.client(1).confirmed() + 70, network.match().game().tick());
  ASSERT_TRUE(network.client(1).slack());
  EXPECT_GE(network.client(1).slack()->slack, 0);
}

// From tick 120 on the inputs arrive three ticks too late.
TEST(Match, ALateInputIsReplacedByTheLastOneAndReportedToItsClient) {
  FakeClientNetwork network(matchOn(farGoalText()), {.delayMs = 4 * kTickMs});
  network.add(FakeClient("Late", 16, [](std::uint32_t tick) { return tick < 150 ? Input::kRight : Input::kLeft; }));
  network.run(120);
  network.client(1).setLead(5);
  network.run(200);
  expectInLockstep(network, 1);
  const auto& decided = network.client(1).decided();
  EXPECT_EQ(decided.at(110), pressing(Input::kRight));
  EXPECT_EQ(decided.at(155), pressing(Input::kRight));
  EXPECT_EQ(decided.rbegin()->second, pressing(0));
  ASSERT_TRUE(network.client(1).slack());
  EXPECT_EQ(network.client(1).slack()->slack, 5 - 2 * 4);
  EXPECT_GT(network.match().find(1)->first().missedInputs(), 100u);
}

// Level and state follow Welcome without a request.
TEST(Match, AClientThatJoinsHasTheGameAfterOneRoundTrip) {
  FakeClientNetwork network(matchOn(farGoalText()), {.delayMs = 6 * kTickMs});
  network.add(player("Early", 16, 1));
  network.run(100);
  network.add(player("Late", 16, 2));
  network.run(2 * 6 + 1);
  const FakeClient& late = network.client(2);
  ASSERT_TRUE(late.game());
  EXPECT_EQ(late.states(), 1u);
  EXPECT_EQ(late.game()->hash(), network.hashOf(1, late.confirmed()));
  EXPECT_GE(late.confirmed() + 6 + 2, network.match().game().tick());
}

TEST(Match, SlackIsTheLeadOfTheNewestInput) {
  FakeClientNetwork network(matchOn(farGoalText()), {.delayMs = 2 * kTickMs});
  network.add(player("Ann", 10));
  network.run(100);
  const auto slack = network.client(1).slack();
  ASSERT_TRUE(slack);
  EXPECT_EQ(slack->slack, 10 - 2 * 2);
}

TEST(Match, AClientWithADesyncGetsTheStateAndKeepsPlaying) {
  FakeClientNetwork network(matchOn(farGoalText()), {.delayMs = 2 * kTickMs});
  network.add(player("Ann", 8, 1));
  network.add(player("Ben", 8, 2));
  network.run(200);
  network.client(1).corruptGame();
  network.run(200);
  EXPECT_EQ(network.count(Kind::kDesync), 1u);
  EXPECT_EQ(network.client(1).states(), 1u);
  EXPECT_GT(network.client(1).desyncs(), 0u);
  const FakeClient& recovered = network.client(1);
  EXPECT_EQ(recovered.hashes().rbegin()->second, network.hashOf(1, recovered.confirmed()));
  EXPECT_GE(recovered.confirmed() + 8, network.match().game().tick());
  expectInLockstep(network, 2);
}

TEST(Match, AClientThatStaysInDesyncGetsOneStateASecond) {
  Match match = matchOn(farGoalText());
  match.receive(1, Hello{});
  std::uint8_t sync = 0;
  for (int tick = 0; tick < 600; ++tick) {
    match.receive(
        1, PlayerInputs{1, sync, match.game().tick(), shortHash(match.game().hash()) + 1, match.game().tick(), {}});
    match.tick();
    for (const Outgoing& message : match.takeOutgoing()) {
      const auto decoded = decodeToClient(message.bytes);
      if (const auto* state = std::get_if<StateChunk>(&*decoded)) sync = state->sync;
    }
  }
  std::size_t states = 0;
  for (const MatchEvent& event : match.takeEvents()) states += event.kind == Kind::kDesync ? 1 : 0;
  EXPECT_EQ(states, 10u);
}

TEST(Match, AClientThatJoinsLateGetsLevelStateAndInputs) {
  FakeClientNetwork network(matchOn(farGoalText()),
                            {.lossPercent = 10, .delayMs = 3 * kTickMs, .jitterMs = 2 * kTickMs, .reorderPercent = 30},
                            3);
  network.add(player("Early", 16, 1));
  network.run(TickHistory::kTicks + 200);
  network.add(player("Late", 16, 2));
  network.run(200);
  const FakeClient& late = network.client(2);
  EXPECT_EQ(late.levels(), 1u);
  EXPECT_EQ(late.states(), 1u);
  EXPECT_EQ(network.count(Kind::kResync), 0u);
  EXPECT_EQ(network.count(Kind::kDesync), 0u);
  expectInLockstep(network, 2);
  expectInLockstep(network, 1);
  EXPECT_TRUE(network.match().game().player(1).present);
}

TEST(Match, ASlotIsFreeOnlyAfterATickWithoutItsPlayer) {
  FakeClientNetwork network(matchOn(farGoalText(), 2));
  network.add(player("Ann"));
  network.add(player("Ben"));
  network.run(60);
  network.match().receive(2, Leave{});
  network.match().receive(9, Hello{});
  EXPECT_FALSE(network.match().isPlaying(9));
  network.match().takeOutgoing();
  network.run(1);
  EXPECT_FALSE(network.match().game().player(1).present);
  network.match().receive(9, Hello{});
  ASSERT_TRUE(network.match().isPlaying(9));
  EXPECT_EQ(network.match().find(9)->first().slot(), 1u);
}

TEST(Match, TheNextRoundIsPlayedOnTheNextLevel) {
  const LevelPointer near = levelOf(nearGoalText());
  const LevelPointer far = levelOf(farGoalText());
  FakeClientNetwork network(Match(LevelRotation({near, far}), {4, ""}), {.delayMs = 2 * kTickMs});
  network.add(player("Ann", 12, 1));
  network.add(player("Ben", 12, 2));
  network.run(60);
  EXPECT_EQ(network.match().round(), 1u);
  const auto end = network.client(1).roundEnd();
  ASSERT_TRUE(end);
  EXPECT_EQ(end->round, 1u);
  EXPECT_EQ(end->nextLevelHash, far->hash);
  network.run(MatchRounds::kPauseTicks + 60);
  EXPECT_EQ(network.match().round(), 2u);
  EXPECT_EQ(network.match().game().level().hash, far->hash);
  for (const ClientId client : {1u, 2u}) {
    EXPECT_EQ(network.client(client).levels(), 2u);
    expectInLockstep(network, client);
    EXPECT_GT(network.client(client).confirmed(), 20u);
  }
  EXPECT_EQ(network.count(Kind::kRoundEnd), 1u);
  EXPECT_EQ(network.count(Kind::kDesync), 0u);
}

TEST(Match, TheNextRoundStartsFiveSecondsAfterTheEnd) {
  FakeClientNetwork network(matchOn(nearGoalText()));
  network.add(player("Ann"));
  for (int tick = 0; network.count(Kind::kRoundEnd) == 0; ++tick) {
    ASSERT_LT(tick, 60);
    network.run(1);
  }
  network.run(MatchRounds::kPauseTicks - 1);
  EXPECT_EQ(network.match().round(), 1u);
  network.run(1);
  EXPECT_EQ(network.match().round(), 2u);
}

TEST(Match, WithoutPlayersTheGameIsPausedAndTheNextPlayerStartsANewRound) {
  FakeClientNetwork network(matchOn(farGoalText()));
  network.add(player("Ann"));
  network.run(100);
  network.leave(1);
  const std::uint32_t tick = network.match().game().tick();
  network.run(100);
  EXPECT_EQ(network.match().game().tick(), tick);
  EXPECT_EQ(network.match().round(), 1u);
  network.add(player("Ben"));
  network.run(50);
  EXPECT_EQ(network.match().round(), 2u);
  expectInLockstep(network, 2);
  EXPECT_EQ(network.client(2).states(), 0u);
}

TEST(Match, LimitsTheLevelsThatAClientRequestsInARound) {
  Match match = matchOn(farGoalText());
  match.receive(1, Hello{});
  std::uint32_t chunks = 0;
  for (int tick = 0; tick < 100; ++tick) {
    match.receive(1, LevelRequest{levelOf(farGoalText())->hash});
    match.receive(1, LevelRequest{12345});
    match.tick();
    for (const Outgoing& message : match.takeOutgoing()) {
      chunks += std::holds_alternative<LevelChunk>(*decodeToClient(message.bytes)) ? 1 : 0;
    }
  }
  EXPECT_EQ(chunks, ClientTransfers::kMaxLevelsPerRound);
}

TEST(Match, AClientThatAcknowledgesNothingIsSentLessAndLess) {
  constexpr std::uint32_t players = 12;
  Match match = matchOn(farGoalText(), players);
  for (ClientId client = 1; client <= players; ++client) match.receive(client, Hello{});
  match.takeOutgoing();
  const std::uint32_t hash = shortHash(match.game().hash());
  std::size_t longest = 0;
  std::size_t sent = 0;
  std::size_t mid = 0;
  for (std::uint32_t tick = 0; tick < 2 * TickHistory::kTicks + 10; ++tick) {
    for (ClientId client = 1; client <= players; ++client) {
      const Input input{static_cast<std::uint8_t>(tick % 8 | Input::kPresent)};
      match.receive(client, PlayerInputs{1, 0, 0, hash, tick, {input}});
    }
    match.tick();
    sent = 0;
    for (const Outgoing& message : match.takeOutgoing()) {
      if (message.reliable) continue;
      ++sent;
      longest = std::max(longest, message.bytes.size());
    }
    EXPECT_LE(sent, players / 2);
    if (tick == 10) mid = sent;
  }
  EXPECT_LE(longest, kMaxMessageBytes);
  EXPECT_EQ(mid, players / 2);
  EXPECT_EQ(sent, 0u);
}

TEST(Match, StoppingTellsAllClientsTheReason) {
  FakeClientNetwork network(matchOn(farGoalText()));
  network.add(player("Ann"));
  network.add(player("Ben"));
  network.run(20);
  network.match().stop("the server stops");
  network.run(5);
  for (const ClientId client : {1u, 2u}) {
    ASSERT_TRUE(network.client(client).bye());
    EXPECT_EQ(network.client(client).bye()->code, ByeCode::kServerStops);
  }
  EXPECT_TRUE(network.match().idle());
}

TEST(Match, TheEndOfARoundIsAnEventWithItsTicks) {
  FakeClientNetwork network(matchOn(nearGoalText()));
  network.add(player("Ann"));
  network.run(20);
  ASSERT_EQ(network.count(Kind::kRoundEnd), 1u);
  const auto end = std::find_if(network.events().begin(), network.events().end(),
                                [](const MatchEvent& event) { return event.kind == Kind::kRoundEnd; });
  EXPECT_EQ(end->ticks, network.client(1).roundEnd()->tick);
}

TEST(Match, NewLevelsArePlayedAfterTheCurrentOne) {
  FakeClientNetwork network(matchOn(nearGoalText()));
  network.add(player("Ann"));
  network.run(10);
  network.match().setLevels({levelOf(farGoalText())});
  EXPECT_EQ(network.match().game().level().hash, levelOf(nearGoalText())->hash);
  network.run(MatchRounds::kPauseTicks + 20);
  EXPECT_EQ(network.match().game().level().hash, levelOf(farGoalText())->hash);
}

}  // namespace
}  // namespace platon::match_test
