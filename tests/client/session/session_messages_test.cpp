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
