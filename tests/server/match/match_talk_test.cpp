#include "server/match/match_talk.h"

#include <gtest/gtest.h>

#include "server/match/match.h"
#include "tests/support/test_levels.h"

namespace platon::match_talk_test {
namespace {

TEST(ChatBudget, ABurstIsSaidAtOnceAndThenOneTextInTwoSeconds) {
  ChatBudget budget = ChatBudget::ofPlayers(1);
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(budget.take(0));
  EXPECT_FALSE(budget.take(0));
  EXPECT_FALSE(budget.take(2 * kTicksPerSecond - 1));
  EXPECT_TRUE(budget.take(2 * kTicksPerSecond));
  EXPECT_FALSE(budget.take(2 * kTicksPerSecond));
}

TEST(ChatBudget, WhatIsDroppedDoesNotCount) {
  ChatBudget budget = ChatBudget::ofPlayers(1);
  for (int i = 0; i < 100; ++i) budget.take(0);
  EXPECT_TRUE(budget.take(2 * kTicksPerSecond));
}

TEST(ChatBudget, TheTimeDoesNotWrapWithinACentury) {
  ChatBudget budget = ChatBudget::ofPlayers(4);
  const std::uint64_t year = std::uint64_t{365} * 24 * 3600 * kTicksPerSecond;
  for (int i = 0; i < 16; ++i) EXPECT_TRUE(budget.take(100 * year));
  EXPECT_FALSE(budget.take(100 * year));
}

// Where a budget counts as full, it is forgotten.
TEST(ChatBudget, IsFullAfterEightSeconds) {
  for (const std::uint32_t players : {1u, 4u, 16u}) {
    ChatBudget budget = ChatBudget::ofPlayers(players);
    for (std::uint32_t i = 0; i < 4 * players; ++i) EXPECT_TRUE(budget.take(0));
    EXPECT_FALSE(budget.take(0));
    for (std::uint32_t i = 0; i < 4 * players; ++i) EXPECT_TRUE(budget.take(ChatBudget::kRefillTicks));
  }
  EXPECT_EQ(ChatBudget::kRefillTicks, 8 * kTicksPerSecond);
}

TEST(NetworkChat, ANetworkSaysAsMuchAsItsPlayers) {
  NetworkChat chat(4);
  for (int i = 0; i < 16; ++i) EXPECT_TRUE(chat.take(7, 0));
  EXPECT_FALSE(chat.take(7, 0));
  EXPECT_FALSE(chat.take(7, kTicksPerSecond / 2 - 1));
  EXPECT_TRUE(chat.take(7, kTicksPerSecond / 2));
  EXPECT_TRUE(chat.take(8, 0)) << "another one";
}

TEST(NetworkChat, NoNetworkSaysMoreThanSixteenPlayers) {
  NetworkChat chat(kMaxPlayers);
  for (int i = 0; i < 64; ++i) EXPECT_TRUE(chat.take(7, 0));
  EXPECT_FALSE(chat.take(7, 0));
}

TEST(NetworkChat, KeepsOnlyThoseWhoHaveTalkedLately) {
  NetworkChat chat(4);
  for (std::uint64_t network = 1; network <= 1000; ++network) chat.take(network, network);
  EXPECT_EQ(chat.size(), ChatBudget::kRefillTicks);
  for (int i = 0; i < 15; ++i) EXPECT_TRUE(chat.take(1000, 1000));
  EXPECT_FALSE(chat.take(1000, 1000)) << "it has said one already";
}

/// A match without a network: messages of clients take effect at once. Client N has slot N - 1.
class MatchChat : public testing::Test {
 protected:
  explicit MatchChat(bool chat = true) : match_(LevelRotation({levelOf(farGoalText())}), settings(chat)) {}

  static MatchSettings settings(bool chat) {
    MatchSettings settings;
    settings.chat = chat;
    settings.playersPerOrigin = 4;
    return settings;
  }
  void join(ClientId first, ClientId last) {
    for (ClientId client = first; client <= last; ++client) {
      Hello hello;
      hello.name = "P" + std::to_string(client);
      hello.token = SessionToken{static_cast<std::uint8_t>(client)};
      match_.receive(client, hello);
    }
    match_.tick();
    match_.takeOutgoing();
    match_.takeEvents();
  }
  void say(ClientId client, const std::string& text) { match_.receive(client, LocalChat{0, {text, 0}}); }
  void run(std::uint32_t ticks) {
    for (; ticks > 0; --ticks) match_.tick();
  }

  // What a client has been sent of the talk since the last call.
  std::vector<PlayerChat> heardBy(ClientId client) {
    std::vector<PlayerChat> found;
    for (const Outgoing& sent : match_.takeOutgoing()) {
      const auto message = decodeToClient(sent.bytes);
      const auto* chat = message ? std::get_if<PlayerChat>(&*message) : nullptr;
      if (chat && sent.client == client) found.push_back(*chat);
    }
    return found;
  }

  Match match_;
};

TEST_F(MatchChat, AllPlayersHearATextAlsoTheSpeaker) {
  join(1, 3);
  const std::vector<PlayerChat> expected{{1, {"Wait for me", 0}}};
  for (const ClientId listener : {1u, 2u, 3u}) {
    run(2 * kTicksPerSecond);
    match_.takeOutgoing();
    say(2, "Wait for me");
    EXPECT_EQ(heardBy(listener), expected) << listener;
  }
}

TEST_F(MatchChat, AnEmoteIsPassedOnWithoutAnEvent) {
  join(1, 2);
  match_.receive(1, LocalChat{0, {"", 3}});
  EXPECT_EQ(heardBy(2), (std::vector<PlayerChat>{{0, {"", 3}}}));
  EXPECT_TRUE(match_.takeEvents().empty());
}

TEST_F(MatchChat, ATextIsAnEventForTheLog) {
  join(1, 2);
  say(2, "Hello");
  const std::vector<MatchEvent> events = match_.takeEvents();
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].kind, MatchEvent::Kind::kChat);
  EXPECT_EQ(events[0].slot, 1U);
  EXPECT_EQ(events[0].text, "Hello");
}

TEST_F(MatchChat, OnlyTheVisiblePartOfATextIsPassedOn) {
  join(1, 2);
  say(1, "  a \u200b  b ");
  say(1, "\u200b");
  EXPECT_EQ(heardBy(2), (std::vector<PlayerChat>{{0, {"a b", 0}}}));
}

TEST_F(MatchChat, AFloodIsDroppedDownToTheRate) {
  join(1, 2);
  for (int second = 0; second < 20; ++second) {
    for (int i = 0; i < 50; ++i) say(1, "flood");
    run(kTicksPerSecond);
  }
  EXPECT_EQ(heardBy(2).size(), 4U + 19 / 2);
}

// Each had a new budget, and all of the match had one together: two households that did this silenced all others.
TEST_F(MatchChat, HouseholdsThatJoinAgainAndAgainDoNotSilenceOthers) {
  const auto joinAt = [this](ClientId client, const char* address) {
    match_.receive(client, Hello{}, *IpAddress::parse(address));
  };
  joinAt(1, "192.0.2.1");
  ClientId next = 2;
  std::size_t heard = 0, flood = 0;
  for (int i = 0; i < 20; ++i) {
    for (int tick = 0; tick < 2 * static_cast<int>(kTicksPerSecond); ++tick) {
      const ClientId loud = next++;
      joinAt(loud, tick % 2 == 0 ? "198.51.100.1" : "203.0.113.1");
      for (int text = 0; text < 4; ++text) say(loud, "flood");
      match_.receive(loud, Leave{});
      match_.tick();
    }
    say(1, "I");
    for (const PlayerChat& each : heardBy(1)) ++(each.chat.text == "I" ? heard : flood);
  }
  EXPECT_EQ(heard, 20u);
  EXPECT_EQ(flood, 2u * (16 + 79)) << "what four players of each household may say in nearly 40 s";
}

TEST_F(MatchChat, ASiteOfManyHouseholdsSaysNoMoreThanSixteenPlayers) {
  join(1, 1);
  for (ClientId client = 2; client < 302; ++client) {
    match_.receive(client, Hello{}, *IpAddress::parse("2001:db8:1:" + std::to_string(client) + "::1"));
    for (int text = 0; text < 4; ++text) say(client, "flood");
    match_.receive(client, Leave{});
    match_.tick();
  }
  EXPECT_EQ(heardBy(1).size(), 64u + 300 * 8 / kTicksPerSecond - 1);
}

// A site is silenced only by itself.
TEST_F(MatchChat, ASiteOfManyHouseholdsSilencesNoOther) {
  match_.receive(1, Hello{}, *IpAddress::parse("2001:db8:2::1"));
  for (ClientId client = 2; client < 302; ++client) {
    match_.receive(client, Hello{}, *IpAddress::parse("2001:db8:1:" + std::to_string(client) + "::1"));
    for (int text = 0; text < 4; ++text) say(client, "flood");
    match_.receive(client, Leave{});
    match_.tick();
  }
  match_.takeOutgoing();
  say(1, "I");
  EXPECT_EQ(heardBy(1), (std::vector<PlayerChat>{{0, {"I", 0}}}));
}

// Their number has no limit, as behind a local relay, so that of a household does not count.
TEST_F(MatchChat, PlayersOnThisMachineSayAsMuchAsSixteen) {
  const auto joinHere = [this](ClientId client) { match_.receive(client, Hello{}, *IpAddress::parse("127.0.0.1")); };
  for (ClientId client = 1; client <= 16; ++client) {
    joinHere(client);
    for (int text = 0; text < 4; ++text) say(client, "a");
  }
  match_.receive(16, Leave{});
  match_.tick();
  joinHere(17);
  say(17, "flood");
  EXPECT_EQ(heardBy(1).size(), 64u);
}

TEST_F(MatchChat, AnotherPlayerIsHeardWhileOneFloods) {
  join(1, 2);
  for (int i = 0; i < 100; ++i) say(1, "flood");
  say(2, "I");
  const std::vector<PlayerChat> heard = heardBy(1);
  ASSERT_FALSE(heard.empty());
  EXPECT_EQ(heard.back(), (PlayerChat{1, {"I", 0}}));
}

TEST_F(MatchChat, AMutedPlayerIsNotHeard) {
  join(1, 2);
  match_.mute(0, true);
  say(1, "a");
  match_.receive(1, LocalChat{0, {"", 1}});
  EXPECT_TRUE(heardBy(2).empty());
  EXPECT_TRUE(match_.takeEvents().empty());
  match_.mute(0, false);
  say(1, "a");
  EXPECT_EQ(heardBy(2).size(), 1U);
}

TEST_F(MatchChat, AStrangerIsNotHeard) {
  join(1, 2);
  say(3, "a");
  EXPECT_TRUE(heardBy(1).empty());
}

// A new connection does not refill what the player may say.
TEST_F(MatchChat, AResumedPlayerKeepsItsBudget) {
  join(1, 2);
  for (int i = 0; i < 4; ++i) say(1, "a");
  match_.disconnect(1);
  Hello again;
  again.name = "P1";
  again.token = SessionToken{1};
  match_.receive(7, again);
  match_.takeOutgoing();
  say(7, "b");
  EXPECT_TRUE(heardBy(2).empty());
}

class SilentMatch : public MatchChat {
 protected:
  SilentMatch() : MatchChat(false) {}
};

TEST_F(SilentMatch, PassesNothingOn) {
  join(1, 2);
  say(1, "a");
  EXPECT_TRUE(heardBy(2).empty());
  EXPECT_TRUE(match_.takeEvents().empty());
}

}  // namespace
}  // namespace platon::match_talk_test
