// Messages that a session ignores, and what ends it.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "client/session/session.h"
#include "tests/support/test_levels.h"

namespace platon::session_messages_test {
namespace {

constexpr std::uint32_t kRound = 1;

/// A session that plays the first round, without a network.
class SessionMessages : public testing::Test {
 protected:
  SessionMessages() {
    receive(Welcome{0, kRound, endlessLevel()->hash, 4, kTicksPerSecond, ""});
    session_.takeOutgoing();
  }

  static Session::Memory memory() {
    Session::Memory memory;
    memory.levels = {endlessLevel()};
    return memory;
  }
  void receive(const auto& message) { session_.receive(encode(message), Time(0)); }
  void receiveText(std::uint64_t hash, const std::string& text) {
    receive(LevelChunk{hash, static_cast<std::uint32_t>(text.size()), 0, {text.begin(), text.end()}});
  }
  std::uint32_t confirmed() const { return session_.round()->prediction().confirmedTicks(); }

  Session session_{"x", Time(0), memory()};
};

/// What the session has asked of companions since the last call.
std::vector<Companion> askedOf(Session& session) {
  std::vector<Companion> asked;
  for (const OutgoingMessage& message : session.takeOutgoing()) {
    const auto decoded = decodeToServer(message.bytes);
    if (decoded && std::holds_alternative<Companion>(*decoded)) asked.push_back(std::get<Companion>(*decoded));
  }
  return asked;
}

TEST_F(SessionMessages, ACompanionPlaysOnceItHasASlot) {
  session_.setCompanion(2, "Ben");
  session_.setCompanion(2, "Ben");
  EXPECT_EQ(askedOf(session_), (std::vector<Companion>{{2, true, "Ben"}}));
  EXPECT_EQ(session_.slots(), (SlotsByLocal{0}));
  receive(LocalSlots{{0, {}, 3}});
  EXPECT_EQ(session_.slots(), (SlotsByLocal{0, {}, 3}));
  EXPECT_EQ(session_.round()->prediction().slots(), (SlotsByLocal{0, {}, 3}));
  session_.setCompanion(2, std::nullopt);
  EXPECT_EQ(askedOf(session_), (std::vector<Companion>{{2, false, ""}}));
  receive(LocalSlots{{0}});
  EXPECT_EQ(session_.round()->prediction().slots(), (SlotsByLocal{0}));
  EXPECT_FALSE(session_.takeNotice());
}

TEST_F(SessionMessages, ARefusalIsToldAndConcernsTheCompanionThatAsked) {
  session_.setCompanion(1, "Ben");
  session_.setCompanion(2, "Cid");
  receive(LocalSlots{{0}, "the server is full", 1});
  EXPECT_EQ(session_.takeNotice(), "the server is full");
  EXPECT_EQ(session_.companions(), (NamesByLocal{{{}, {}, "Cid"}}));
  receive(LocalSlots{{0, {}, 1}, "", 2});
  EXPECT_EQ(session_.companions(), (NamesByLocal{{{}, {}, "Cid"}}));
}

TEST_F(SessionMessages, ARemovedCompanionDoesNotComeAgain) {
  session_.setCompanion(1, "Ben");
  receive(LocalSlots{{0, 2}, "", 1});
  session_.setCompanion(2, "Cid");
  receive(LocalSlots{{0}, "removed by the operator"});
  EXPECT_EQ(session_.takeNotice(), "removed by the operator");
  EXPECT_EQ(session_.companions(), (NamesByLocal{{{}, {}, "Cid"}})) << "its request is not answered yet";
}

TEST_F(SessionMessages, WhoHasLeftDuringAnOutageLeavesAfterIt) {
  session_.setCompanion(1, "Ben");
  receive(LocalSlots{{0, 2}, "", 1});
  session_.connectionLost("gone");
  Session::Memory left = session_.memory();
  left.companions[1].reset();
  Session next("x", Time(0), left);
  next.receive(encode(Welcome{0, kRound, endlessLevel()->hash, 4, kTicksPerSecond, ""}), Time(0));
  EXPECT_TRUE(askedOf(next).empty());
  next.receive(encode(LocalSlots{{0, 2}}), Time(0));
  EXPECT_EQ(askedOf(next), (std::vector<Companion>{{1, false, ""}}));
}

TEST_F(SessionMessages, CompanionsComeAgainWithTheNextSession) {
  session_.setCompanion(1, "Ben");
  session_.setCompanion(3, "");
  receive(LocalSlots{{0, 2}});
  receive(LocalSlots{{0, 2, {}, 1}});
  session_.connectionLost("gone");
  Session next("x", Time(0), session_.memory());
  EXPECT_TRUE(askedOf(next).empty()) << "not before Welcome";
  next.receive(encode(Welcome{0, kRound, endlessLevel()->hash, 4, kTicksPerSecond, ""}), Time(0));
  EXPECT_EQ(askedOf(next), (std::vector<Companion>{{1, true, "Ben"}, {3, true, ""}}));
}

TEST(SessionCompanions, SlotsThatThereAreNotEndTheSession) {
  const auto endingAfter = [](const LocalSlots& slots, bool isWelcome = true) {
    Session session("x", Time(0));
    if (isWelcome) session.receive(encode(Welcome{2, 1, 17, 4, kTicksPerSecond, ""}), Time(0));
    session.receive(encode(slots), Time(0));
    return session.ending() ? session.ending()->reason : std::string();
  };
  const std::string error = "protocol error: the server gives slots that there are not";
  EXPECT_EQ(endingAfter({{2, 3}}), "");
  EXPECT_EQ(endingAfter({{2, 4}}), error);
  EXPECT_EQ(endingAfter({{1, 3}}), error) << "another slot of the first player";
  EXPECT_EQ(endingAfter({{2}}, false), error) << "before Welcome";
}

TEST_F(SessionMessages, TicksOfAnotherRoundAreIgnored) {
  receive(ConfirmedTicks{kRound + 1, 0, 5, 0, std::nullopt, {}});
  EXPECT_EQ(confirmed(), 0u);
  receive(ConfirmedTicks{kRound, 0, 5, 0, std::nullopt, {}});
  EXPECT_EQ(confirmed(), 5u);
}

TEST_F(SessionMessages, AStateOfAnotherRoundIsIgnored) {
  const std::vector<std::uint8_t> bytes = encode(FullState{{}, Game(endlessLevel()).save()});
  StateChunk chunk;
  chunk.round = kRound + 1;
  chunk.tick = 100;
  chunk.sync = 1;
  chunk.total = static_cast<std::uint32_t>(bytes.size());
  chunk.bytes = bytes;
  receive(chunk);
  EXPECT_EQ(confirmed(), 0u);
  chunk.round = kRound;
  receive(chunk);
  EXPECT_EQ(confirmed(), 100u);
}

TEST_F(SessionMessages, ALevelThatWasNotRequestedIsIgnored) {
  receiveText(cornerLevel()->hash, std::string(cornerLevel()->text));
  EXPECT_EQ(session_.memory().levels.size(), 1u);
  EXPECT_FALSE(session_.ending());
}

TEST_F(SessionMessages, ALevelWithAnotherHashThanThatRequestedEndsTheSession) {
  constexpr std::uint64_t kHash = 99;
  receive(RoundStart{kRound + 1, kHash});
  receiveText(kHash, std::string(cornerLevel()->text));
  ASSERT_TRUE(session_.ending());
  EXPECT_EQ(session_.ending()->reason, "protocol error: invalid level from the server");
  EXPECT_TRUE(session_.ending()->permanent);
}

TEST_F(SessionMessages, ANameInASlotThatTheServerDoesNotHaveIsIgnored) {
  receive(Roster{{{4, "Ann"}, {255, "Ben"}, {3, "Cleo"}}});
  ASSERT_EQ(session_.names().size(), 4u);
  EXPECT_EQ(session_.names()[3], "Cleo");
}

TEST_F(SessionMessages, AfterTheEndNothingIsSentAndItsReasonStays) {
  receive(Bye{ByeCode::kServerStops, "first"});
  const std::string reason = session_.ending()->reason;
  receive(Bye{ByeCode::kRemoved, "second"});
  session_.connectionLost("third");
  session_.leave();
  session_.toggleVote();
  session_.update(std::chrono::seconds(1), [](const Game&, std::uint32_t) { return Input(); });
  EXPECT_TRUE(session_.takeOutgoing().empty());
  EXPECT_EQ(session_.ending()->reason, reason);
  EXPECT_FALSE(session_.ending()->permanent);
}

}  // namespace
}  // namespace platon::session_messages_test
