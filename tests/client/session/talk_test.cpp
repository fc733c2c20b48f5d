// What players say to each other.
#include "client/session/talk.h"

#include <gtest/gtest.h>

#include "client/session/session.h"
#include "platon/game/game.h"

namespace platon::talk_test {
namespace {

using std::chrono::microseconds;
using std::chrono::seconds;

/// A session that the server has accepted, without a network.
class SessionChat : public testing::Test {
 protected:
  SessionChat() {
    receive(Welcome{3, 1, 17, 16, kTicksPerSecond, "Test"});
    session_.takeOutgoing();
  }

  void receive(const auto& message) { session_.receive(encode(message), Time(0)); }
  std::vector<LocalChat> sent() {
    std::vector<LocalChat> found;
    for (const OutgoingMessage& message : session_.takeOutgoing()) {
      EXPECT_TRUE(message.reliable);
      const auto decoded = decodeToServer(message.bytes);
      if (decoded && std::holds_alternative<LocalChat>(*decoded)) found.push_back(std::get<LocalChat>(*decoded));
    }
    return found;
  }

  Session session_{"Ann", Time(0)};
};

TEST_F(SessionChat, ATextAndAnEmoteAreSent) {
  EXPECT_TRUE(session_.say({"Hello", 0}, Time(0)));
  EXPECT_TRUE(session_.say({"", 2}, Time(0)));
  EXPECT_EQ(sent(), (std::vector<LocalChat>{{0, {"Hello", 0}}, {0, {"", 2}}}));
}

TEST_F(SessionChat, WhatTheServerWouldDropIsNotSent) {
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(session_.say({"a", 0}, Time(0)));
  EXPECT_FALSE(session_.say({"b", 0}, seconds(1)));
  EXPECT_TRUE(session_.say({"c", 0}, seconds(2)));
  EXPECT_EQ(sent().size(), 5U);
}

TEST_F(SessionChat, EachLocalPlayerHasABudgetOfItsOwn) {
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(session_.say({"a", 0}, Time(0)));
  EXPECT_FALSE(session_.say({"a", 0}, Time(0)));
  EXPECT_TRUE(session_.say({"b", 0}, Time(0), 2));
  EXPECT_EQ(sent().back(), (LocalChat{2, {"b", 0}}));
}

TEST_F(SessionChat, NothingIsSentBeforeWelcomeAndAfterTheEnd) {
  Session early("Ben", Time(0));
  EXPECT_FALSE(early.say({"a", 0}, Time(0)));
  receive(Bye{ByeCode::kServerStops, ""});
  EXPECT_FALSE(session_.say({"a", 0}, Time(0)));
}

TEST_F(SessionChat, WhatPlayersSayIsTakenOnce) {
  receive(PlayerChat{3, {"mine", 0}});
  receive(PlayerChat{5, {"", 1}});
  EXPECT_EQ(session_.takeChats(), (std::vector<PlayerChat>{{3, {"mine", 0}}, {5, {"", 1}}}));
  EXPECT_TRUE(session_.takeChats().empty());
}

TEST_F(SessionChat, OnlyTheVisiblePartIsKept) {
  receive(PlayerChat{5, {"a \u200b b", 0}});
  receive(PlayerChat{5, {"\u200b", 0}});
  EXPECT_EQ(session_.takeChats(), (std::vector<PlayerChat>{{5, {"a b", 0}}}));
}

TEST_F(SessionChat, AFloodDropsTheOldest) {
  for (std::size_t i = 0; i < Talk::kMaxChats + 10; ++i) receive(PlayerChat{5, {std::to_string(i), 0}});
  const std::vector<PlayerChat> kept = session_.takeChats();
  ASSERT_EQ(kept.size(), Talk::kMaxChats);
  EXPECT_EQ(kept.front().chat.text, "10");
}

/// A session that the server has accepted, without a network; the players in slots 1 and 3 have names.
class SessionRoundTrips : public testing::Test {
 protected:
  SessionRoundTrips() {
    receive(Welcome{3, 1, 17, 4, kTicksPerSecond, "Test"});
    receive(Roster{{{1, "Ben"}, {3, "Ann"}}});
  }
  void receive(const auto& message) { session_.receive(encode(message), Time(0)); }
  std::optional<std::uint32_t> of(std::uint32_t slot) const { return session_.roundTripMs(slot, seconds(1)); }

  Session session_{"Ann", Time(0)};
};

TEST_F(SessionRoundTrips, AreThoseThatTheServerTells) {
  EXPECT_EQ(of(1), std::nullopt);
  receive(RoundTrips{{0, codeOfRoundTrip(20), 0, codeOfRoundTrip(0)}});
  EXPECT_EQ(of(1), 20u);
  EXPECT_EQ(of(3), 0u);
}

TEST_F(SessionRoundTrips, ADisconnectedPlayerAndAFreeSlotHaveNone) {
  receive(RoundTrips{{9, kNoRoundTrip, 9, 9}});
  EXPECT_EQ(of(0), std::nullopt);
  EXPECT_EQ(of(1), std::nullopt);
  EXPECT_EQ(of(3), 32u);
  receive(Roster{{{3, ""}}});
  EXPECT_EQ(of(3), std::nullopt);
}

/// A hostile server may send as many as a message can hold.
TEST_F(SessionRoundTrips, SlotsThatTheMatchDoesNotHaveAreIgnored) {
  receive(RoundTrips{std::vector<std::uint8_t>(kMaxPlayers, 9)});
  EXPECT_EQ(of(1), 32u);
  EXPECT_EQ(of(4), std::nullopt);
  EXPECT_EQ(of(kMaxPlayers), std::nullopt);
  EXPECT_FALSE(session_.ending());
}

TEST_F(SessionRoundTrips, BeforeWelcomeNobodyHasOne) {
  Session early("Ben", Time(0));
  early.receive(encode(RoundTrips{{9}}), Time(0));
  EXPECT_EQ(early.roundTripMs(0, Time(0)), std::nullopt);
  EXPECT_FALSE(early.ending());
}

TEST(Talk, ASlotHasTheRoundTripThatTheNewestMessageTells) {
  Talk talk(Time(0));
  talk.setSlots(4);
  talk.receive(Roster{{{0, "Ann"}, {1, "Ben"}, {2, "Cleo"}, {3, "Dan"}}}, seconds(1));
  EXPECT_EQ(talk.roundTripMs(0, seconds(1)), std::nullopt);
  talk.receive(RoundTrips{{codeOfRoundTrip(20), kNoRoundTrip, codeOfRoundTrip(5000)}}, seconds(1));
  EXPECT_EQ(talk.roundTripMs(0, seconds(1)), 20u);
  EXPECT_EQ(talk.roundTripMs(1, seconds(1)), std::nullopt);
  EXPECT_EQ(talk.roundTripMs(2, seconds(1)), kMaxRoundTripMs);
  EXPECT_EQ(talk.roundTripMs(3, seconds(1)), std::nullopt);
  talk.receive(RoundTrips{{codeOfRoundTrip(40)}}, seconds(2));
  EXPECT_EQ(talk.roundTripMs(0, seconds(2)), 40u);
  EXPECT_EQ(talk.roundTripMs(2, seconds(2)), std::nullopt);
}

TEST(Talk, AnOldRoundTripIsForgotten) {
  Talk talk(Time(0));
  talk.setSlots(1);
  talk.receive(Roster{{{0, "Ann"}}}, Time(0));
  talk.receive(RoundTrips{{codeOfRoundTrip(20)}}, seconds(1));
  EXPECT_EQ(talk.roundTripMs(0, seconds(1) + Talk::kRoundTripTimeout), 20u);
  EXPECT_EQ(talk.roundTripMs(0, seconds(1) + Talk::kRoundTripTimeout + microseconds(1)), std::nullopt);
}

TEST(Talk, ShowsOnlyWhatCanBeSeenOfANotice) {
  Talk talk(Time(0));
  talk.receive(Notice{"a\xe2\x80\x8b  b"}, Time(0));
  EXPECT_EQ(talk.takeNotice(), "a b");
  talk.receive(Notice{"\xe2\x80\x8b"}, Time(0));
  EXPECT_EQ(talk.takeNotice(), std::nullopt);
}

}  // namespace
}  // namespace platon::talk_test
