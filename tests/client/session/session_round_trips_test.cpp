// What a session knows of the round trips of the players.
#include <gtest/gtest.h>

#include "client/session/session.h"

namespace platon::session_round_trips_test {
namespace {

using std::chrono::seconds;

/// A session that the server has accepted, without a network; the players in slots 1 and 3 have names.
class SessionRoundTrips : public testing::Test {
 protected:
  SessionRoundTrips() {
    receive(Welcome{3, 1, 17, 4, kTicksPerSecond, "Test"});
    receive(Roster{{{1, "Ben"}, {3, "Ann"}}});
  }
  void receive(const auto& message) { session_.receive(encode(message), Moment(0)); }
  std::optional<std::uint32_t> of(std::uint32_t slot) const { return session_.roundTripMs(slot, seconds(1)); }

  Session session_{"Ann", Moment(0)};
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
  Session early("Ben", Moment(0));
  early.receive(encode(RoundTrips{{9}}), Moment(0));
  EXPECT_EQ(early.roundTripMs(0, Moment(0)), std::nullopt);
  EXPECT_FALSE(early.ending());
}

}  // namespace
}  // namespace platon::session_round_trips_test
