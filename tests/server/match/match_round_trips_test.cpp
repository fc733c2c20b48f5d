#include <gtest/gtest.h>

#include <map>

#include "protocol/round_trip_code.h"
#include "server/match/match.h"
#include "tests/support/test_levels.h"

namespace platon::match_round_trips_test {
namespace {

/// A match without a network: messages of clients take effect at once. Client N has slot N - 1 and a round trip of
/// 20 N ms.
class MatchRoundTrips : public testing::Test {
 protected:
  MatchRoundTrips() : match_(LevelRotation({levelOf(farGoalText())}), {}) {
    match_.setRoundTrip([](ClientId client) { return static_cast<std::uint32_t>(20 * client); });
  }
  void join(ClientId first, ClientId last) {
    for (ClientId client = first; client <= last; ++client) {
      Hello hello;
      hello.token = SessionToken{static_cast<std::uint8_t>(client)};
      match_.receive(client, hello);
    }
  }
  // The messages of the next ticks by client.
  std::map<ClientId, std::vector<RoundTrips>> sentIn(std::uint64_t ticks) {
    std::map<ClientId, std::vector<RoundTrips>> found;
    for (; ticks > 0; --ticks) {
      match_.tick();
      for (const Outgoing& sent : match_.takeOutgoing()) {
        const auto message = decodeToClient(sent.bytes);
        const auto* trips = message ? std::get_if<RoundTrips>(&*message) : nullptr;
        if (trips == nullptr) continue;
        EXPECT_FALSE(sent.reliable || sent.last);
        found[sent.client].push_back(*trips);
      }
    }
    return found;
  }

  Match match_;
};

TEST_F(MatchRoundTrips, EveryPlayerIsToldThoseOfAllOnceInTwoSeconds) {
  join(1, 3);
  const RoundTrips expected{{codeOfRoundTrip(20), codeOfRoundTrip(40), codeOfRoundTrip(60)}};
  const auto sent = sentIn(10 * kTicksPerSecond);
  ASSERT_EQ(sent.size(), 3u);
  for (const auto& [client, messages] : sent) EXPECT_EQ(messages, std::vector<RoundTrips>(5, expected)) << client;
}

TEST_F(MatchRoundTrips, APlayerWhoIsAloneIsToldNone) {
  join(1, 1);
  EXPECT_TRUE(sentIn(10 * kTicksPerSecond).empty());
}

TEST_F(MatchRoundTrips, AMatchThatDoesNotKnowThemTellsNone) {
  match_.setRoundTrip({});
  join(1, 3);
  EXPECT_TRUE(sentIn(10 * kTicksPerSecond).empty());
}

TEST_F(MatchRoundTrips, APlayerWhoHasLeftOrIsDisconnectedHasNone) {
  join(1, 5);
  match_.tick();
  match_.remove(1);
  match_.disconnect(3);
  match_.disconnect(5);
  const auto sent = sentIn(Match::kRoundTripsTicks);
  ASSERT_EQ(sent.size(), 2u);
  EXPECT_EQ(sent.at(2), (std::vector<RoundTrips>{{{0, codeOfRoundTrip(40), 0, codeOfRoundTrip(80)}}}));
}

/// The largest match: a message still fits into a datagram, together with all that ENet and the seal add.
TEST_F(MatchRoundTrips, AMessageOfTheLargestMatchIsShort) {
  const RoundTrips all{std::vector<std::uint8_t>(kMaxPlayers, UINT8_MAX)};
  EXPECT_LE(encode(all).size(), 320u);
  const RoundTrips sixteen{std::vector<std::uint8_t>(16, UINT8_MAX)};
  EXPECT_LE(encode(sixteen).size(), 80u);
}

}  // namespace
}  // namespace platon::match_round_trips_test
