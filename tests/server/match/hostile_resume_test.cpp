#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "server/match/match.h"
#include "tests/net/support/fake_client.h"
#include "tests/net/support/fake_client_network.h"
#include "tests/sim/verify/verification.h"
#include "tests/support/test_levels.h"

namespace platon::hostile_resume_test {
namespace {

using Kind = MatchEvent::Kind;

int running(std::uint32_t) { return Input::kRight; }

SessionToken tokenNumber(std::uint32_t number) {
  return {0xee, static_cast<std::uint8_t>(number), static_cast<std::uint8_t>(number >> 8)};
}

Hello hello(const std::string& name, std::optional<SessionToken> token) {
  Hello hello;
  hello.name = name;
  hello.token = token;
  return hello;
}

// An address of this household; 0: this machine.
IpAddress addressOf(std::uint8_t origin) {
  if (origin == 0) return IpAddress::ofIpv4({127, 0, 0, 1});
  IpAddress address;
  address.bytes[7] = origin;
  return address;
}

/// A match that receives messages without a network.
class HostileResume : public testing::Test {
 protected:
  static Match matchFor(std::uint32_t maxPlayers, std::uint32_t playersPerOrigin = kMaxPlayers) {
    MatchSettings settings;
    settings.maxPlayers = maxPlayers;
    settings.playersPerOrigin = playersPerOrigin;
    return Match(LevelRotation({levelOf(farGoalText())}), settings);
  }

  void sendHello(Match& match, ClientId client, std::uint32_t token, std::uint8_t origin = 0) {
    match.receive(client, hello("P" + std::to_string(token), tokenNumber(token)), addressOf(origin));
  }

  // Runs one tick and counts its messages and events.
  void tick(Match& match) {
    match.tick();
    sent_.clear();
    for (const Outgoing& message : match.takeOutgoing()) ++sent_[message.client];
    for (const MatchEvent& event : match.takeEvents()) ++events_[event.kind];
  }

  std::map<ClientId, std::size_t> sent_;
  std::map<Kind, std::size_t> events_;
};

// It counted where it had joined: two households that moved and resumed each other's players filled a server.
TEST_F(HostileResume, APlayerThatMovesCountsWhereItIs) {
  Match match = matchFor(8, 2);
  sendHello(match, 1, 1, 7);
  sendHello(match, 2, 2, 7);
  EXPECT_TRUE(match.move(1, addressOf(8)));
  EXPECT_TRUE(match.move(2, addressOf(8)));
  sendHello(match, 3, 3, 8);
  EXPECT_FALSE(match.isPlaying(3));
  sendHello(match, 4, 4, 7);
  EXPECT_TRUE(match.isPlaying(4));
  EXPECT_FALSE(match.move(4, addressOf(8)));
  EXPECT_EQ(match.find(4)->address(), addressOf(7));
  EXPECT_TRUE(match.move(1, addressOf(8))) << "another address of the same household";
  EXPECT_TRUE(match.move(99, addressOf(8))) << "a client without a player";
}

TEST_F(HostileResume, APlayerCannotBeResumedWhereAllPlayersAreConnected) {
  Match match = matchFor(8, 2);
  for (std::uint32_t i = 1; i <= 4; ++i) sendHello(match, i, i, i <= 2 ? 7 : 8);
  tick(match);
  match.disconnect(1);
  sendHello(match, 5, 1, 8);  // disconnected
  sendHello(match, 6, 2, 8);  // connected
  EXPECT_FALSE(match.isPlaying(5));
  EXPECT_FALSE(match.isPlaying(6));
  EXPECT_TRUE(match.isPlaying(2));
  sendHello(match, 7, 3, 8);
  EXPECT_TRUE(match.isPlaying(7)) << "it is there already";
  sendHello(match, 8, 1, 7);
  EXPECT_TRUE(match.isPlaying(8)) << "its player was kept";
  tick(match);
  EXPECT_EQ(events_[Kind::kRefused], 2u);
  EXPECT_EQ(events_[Kind::kLeft], 0u);
}

// As one that joins there does.
TEST_F(HostileResume, APlayerThatMovesTakesThePlaceOfADisconnectedOne) {
  Match match = matchFor(8, 2);
  for (std::uint32_t i = 1; i <= 3; ++i) sendHello(match, i, i, i <= 2 ? 8 : 7);
  tick(match);
  match.disconnect(1);
  EXPECT_TRUE(match.move(3, addressOf(8)));
  EXPECT_EQ(match.allPlayers(), 2u);
}

TEST_F(HostileResume, ThisMachineMayGatherAnyNumberOfPlayers) {
  Match match = matchFor(8, 2);
  for (std::uint32_t i = 1; i <= 6; ++i) {
    sendHello(match, i, i, static_cast<std::uint8_t>(i));
    EXPECT_TRUE(match.move(i, addressOf(0)));
  }
  EXPECT_EQ(match.players(), 6u);
}

TEST_F(HostileResume, ASecondHelloChangesNothing) {
  Match match = matchFor(4);
  sendHello(match, 1, 1);
  sendHello(match, 1, 2);
  sendHello(match, 1, 1);
  tick(match);
  EXPECT_EQ(match.players(), 1u);
  EXPECT_EQ(match.find(1)->first().name(), "P1");
  EXPECT_TRUE(match.find(1)->hasToken(tokenNumber(1)));
  EXPECT_EQ(events_[Kind::kJoined], 1u);
  EXPECT_EQ(events_[Kind::kResumed], 0u);
}

// Two connections with one token send many Hellos before the server can close either.
TEST_F(HostileResume, AConnectionThatIsClosingCannotResume) {
  Match match = matchFor(4);
  sendHello(match, 9, 9);
  tick(match);
  for (int i = 0; i < 200; ++i) {
    sendHello(match, 1, 1);
    sendHello(match, 2, 1);
    sendHello(match, 3, 1);
  }
  tick(match);
  EXPECT_EQ(match.players(), 2u);
  EXPECT_TRUE(match.isPlaying(3));
  EXPECT_LE(events_[Kind::kResumed], 2u);
  EXPECT_LE(sent_[9], 5u);  // names only
}

// Two addresses that resume each other's players hold no more players than two addresses may.
TEST_F(HostileResume, ResumingFromAnotherAddressCountsAgainstThatAddress) {
  Match match = matchFor(16, 4);
  for (std::uint32_t cycle = 0; cycle < 16; ++cycle) {
    const ClientId client = 1 + 2 * cycle;
    sendHello(match, client, cycle, 1);
    sendHello(match, client + 1, cycle, 2);
    match.disconnect(client + 1);
    tick(match);
  }
  sendHello(match, 99, 99, 3);
  EXPECT_TRUE(match.isPlaying(99));
  EXPECT_GE(events_[Kind::kLeft], 11u);
}

TEST_F(HostileResume, ATokenOfZerosIsATokenLikeAnyOther) {
  Match match = matchFor(4);
  sendHello(match, 9, 9);
  match.receive(1, hello("One", SessionToken{}));
  match.receive(2, hello("Two", std::nullopt));
  tick(match);
  EXPECT_EQ(match.players(), 3u);
  match.receive(3, hello("Three", SessionToken{}));
  tick(match);
  EXPECT_EQ(match.players(), 3u);
  EXPECT_FALSE(match.isPlaying(1));
  EXPECT_TRUE(match.isPlaying(2));
  EXPECT_TRUE(match.isPlaying(9));
}

TEST_F(HostileResume, AllPlayersOfAFullServerCanDisconnectAtOnce) {
  Match match = matchFor(kMaxPlayers);
  for (std::uint32_t i = 0; i < kMaxPlayers; ++i) sendHello(match, 1 + i, i);
  for (int i = 0; i < 10; ++i) tick(match);
  std::vector<std::uint32_t> slots;
  for (std::uint32_t i = 0; i < kMaxPlayers; ++i) slots.push_back(match.find(1 + i)->first().slot());
  for (std::uint32_t i = 0; i < kMaxPlayers; ++i) match.disconnect(1 + i);
  tick(match);
  EXPECT_TRUE(sent_.empty());
  EXPECT_FALSE(match.idle());
  sendHello(match, 999, 999);  // no slot is free
  EXPECT_FALSE(match.isPlaying(999));
  for (std::uint32_t i = kMaxPlayers; i-- > kMaxPlayers / 2;) sendHello(match, 1001 + i, i);
  tick(match);
  EXPECT_EQ(match.players(), kMaxPlayers / 2);
  for (std::uint32_t i = kMaxPlayers / 2; i < kMaxPlayers; ++i)
    EXPECT_EQ(match.find(1001 + i)->first().slot(), slots[i]);
  for (std::uint64_t i = 0; i < MatchRoster::kResumeTicks + 2; ++i) match.tick();
  tick(match);
  EXPECT_EQ(events_[Kind::kLeft], kMaxPlayers / 2);
  for (std::uint32_t i = 0; i < kMaxPlayers / 2; ++i) sendHello(match, 2001 + i, 2000 + i);
  EXPECT_EQ(match.players(), kMaxPlayers);
}

TEST_F(HostileResume, AMatchForOneKeepsTheSlotForItsDisconnectedPlayer) {
  Match match = matchFor(1);
  sendHello(match, 1, 1);
  for (int i = 0; i < 10; ++i) tick(match);
  match.disconnect(1);
  sendHello(match, 2, 2);
  EXPECT_FALSE(match.isPlaying(2));
  tick(match);
  sendHello(match, 3, 1);
  ASSERT_TRUE(match.isPlaying(3));
  EXPECT_EQ(match.find(3)->first().slot(), 0u);
  match.disconnect(3);
  for (std::uint64_t i = 0; i <= MatchRoster::kResumeTicks; ++i) tick(match);
  EXPECT_TRUE(match.idle());
  sendHello(match, 4, 4);
  EXPECT_TRUE(match.isPlaying(4));
}

TEST_F(HostileResume, APlayerThatHasLeftIsNotReportedAsDisconnected) {
  Match match = matchFor(4);
  sendHello(match, 1, 1);
  tick(match);
  match.receive(1, Leave{});
  match.disconnect(1);
  tick(match);
  EXPECT_TRUE(match.idle());
  EXPECT_EQ(events_[Kind::kLeft], 1u);
  EXPECT_EQ(events_[Kind::kConnectionLost], 0u);
}

// A client that repeatedly disconnects must not occupy all slots.
TEST_F(HostileResume, AnAddressHoldsOnlyAsManySlotsAsItMayHaveConnections) {
  constexpr std::uint8_t kAttacker = 7, kOther = 8;
  Match match = matchFor(16, 4);
  sendHello(match, 1, 1, kOther);
  sendHello(match, 2, 2, kOther);
  tick(match);
  match.disconnect(1);
  for (std::uint32_t i = 0; i < 50; ++i) {
    sendHello(match, 100 + i, 100 + i, kAttacker);
    tick(match);
    match.disconnect(100 + i);
  }
  EXPECT_EQ(events_[Kind::kJoined], 52u);
  EXPECT_EQ(events_[Kind::kLeft], 46u);  // those disconnected longest
  EXPECT_EQ(events_[Kind::kRefused], 0u);
  sendHello(match, 200, 149, kAttacker);
  EXPECT_TRUE(match.isPlaying(200));
  sendHello(match, 3, 1, kOther);
  tick(match);
  EXPECT_EQ(match.find(3)->first().slot(), 0u);  // its player was kept
  EXPECT_EQ(events_[Kind::kResumed], 2u);
}

TEST_F(HostileResume, ConnectedPlayersAreNeverEvicted) {
  Match match = matchFor(16, 2);
  for (std::uint32_t i = 1; i <= 3; ++i) sendHello(match, i, i, 7);
  tick(match);
  EXPECT_EQ(match.players(), 2u);
  EXPECT_TRUE(match.isPlaying(1) && match.isPlaying(2));
  EXPECT_EQ(events_[Kind::kLeft], 0u);
}

TEST(ResumeDuringATransfer, TheLevelIsSentAgainFromItsStart) {
  const std::string text = farGoalText() + std::string(20000, '\n');
  FakeClientNetwork network(Match(LevelRotation({levelOf(text)}), {4, "Test"}));
  network.add(FakeClient("Ann", 12, running));
  network.run(3);
  network.disconnect(1);  // some chunks have arrived
  network.run(200);
  network.add(FakeClient(network.client(1), running));
  network.run(60);
  EXPECT_EQ(network.client(1).levels(), 0u);
  EXPECT_EQ(network.client(2).levels(), 1u);
  EXPECT_EQ(network.client(2).welcome()->slot, 0u);
  EXPECT_GT(network.client(2).confirmed(), 200u);
  EXPECT_EQ(network.client(2).desyncs(), 0u);
  EXPECT_TRUE(network.match().game().player(0).present);
}

// The recording goes on while players are disconnected, and ends when the last of them is removed.
TEST(ResumeWhileRecording, TheWholeGameIsRecorded) {
  FakeClientNetwork network(Match(LevelRotation({levelOf(farGoalText())}), {4, "Test", true}),
                            {.delayMs = 2 * kTickMs});
  network.add(FakeClient("Ann", 12, running));
  network.add(FakeClient("Ben", 12, running));
  network.run(100);
  network.disconnect(1);
  network.run(100);
  network.disconnect(2);
  network.run(100);
  network.add(FakeClient(network.client(1), [](std::uint32_t) { return 0; }));
  network.run(100);
  network.disconnect(3);
  network.run(MatchRoster::kResumeTicks + 10);
  ASSERT_TRUE(network.match().idle());
  std::vector<std::uint8_t> bytes;
  std::size_t ends = 0;
  for (const RecordingPiece& piece : network.match().takeRecording()) {
    bytes.insert(bytes.end(), piece.bytes.begin(), piece.bytes.end());
    ends += piece.last ? 1 : 0;
  }
  EXPECT_EQ(ends, 1u);
  const sim::Verification found = sim::Verifier(bytes).run(
      [&](std::span<const Input>, const Game& game) { EXPECT_EQ(game.hash(), network.hashOf(1, game.tick())); });
  EXPECT_FALSE(found.divergence.has_value());
  EXPECT_EQ(found.fault, "");
  EXPECT_EQ(found.ticks, network.match().game().tick());
  EXPECT_GT(found.ticks, 390 + MatchRoster::kResumeTicks);
}

// All of an address's players are connected: none makes room.
TEST_F(HostileResume, TheFifthPlayerOfAnAddressIsToldWhy) {
  Match match = matchFor(16, 4);
  for (std::uint32_t i = 1; i <= 5; ++i) sendHello(match, i, i, 7);
  EXPECT_EQ(match.players(), 4u);
  std::optional<Refused> refused;
  for (const Outgoing& message : match.takeOutgoing()) {
    const auto decoded = decodeToClient(message.bytes);
    if (const auto* found = std::get_if<Refused>(&*decoded)) refused = *found;
  }
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->reason, "your address already has 4 players, which is all that this server allows");
  sendHello(match, 6, 6, 8);
  EXPECT_EQ(match.players(), 5u);
}

}  // namespace
}  // namespace platon::hostile_resume_test
