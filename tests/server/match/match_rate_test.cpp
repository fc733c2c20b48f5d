#include <gtest/gtest.h>

#include <map>
#include <string>

#include "server/match/match.h"
#include "tests/support/test_levels.h"

namespace platon {
namespace {

constexpr int kTicks = 60;

// Numbers of messages of ticks that each of so many players is sent.
std::map<ClientId, int> messagesIn(int ticks, std::uint32_t players) {
  Match match(LevelRotation({levelOf(farGoalText())}), {kMaxPlayers, "Test"});
  for (ClientId client = 1; client <= players; ++client) match.receive(client, Hello{});
  std::map<ClientId, int> messages;
  for (int tick = 0; tick < ticks; ++tick) {
    match.tick();
    for (const Outgoing& message : match.takeOutgoing()) messages[message.client] += message.reliable ? 0 : 1;
  }
  return messages;
}

class MatchRateTest : public testing::TestWithParam<std::pair<std::uint32_t, int>> {};

TEST_P(MatchRateTest, TheMorePlayersTheRarerTheMessages) {
  const auto [players, interval] = GetParam();
  const std::map<ClientId, int> messages = messagesIn(kTicks, players);
  ASSERT_EQ(messages.size(), players);
  for (const auto& [client, count] : messages) EXPECT_EQ(count, kTicks / interval) << "client " << client;
}

INSTANTIATE_TEST_SUITE_P(Players, MatchRateTest,
                         testing::Values(std::pair(1u, 1), std::pair(4u, 1), std::pair(5u, 2), std::pair(32u, 2),
                                         std::pair(33u, 3), std::pair(kMaxPlayers, 3)));

}  // namespace
}  // namespace platon
