#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "server/match/match.h"
#include "tests/support/test_levels.h"

namespace platon {
namespace {

Match matchOn(const std::string& text, std::uint32_t maxPlayers) {
  return Match(LevelRotation({levelOf(text)}), {maxPlayers, "Test"});
}

// All clients together get kMaxChunksPerTick chunks a tick, in turns, until each has the whole level.
TEST(MatchTransfers, SendsABoundedNumberOfChunksPerTick) {
  constexpr std::uint32_t kChunksEach = 10;
  std::string text = farGoalText();
  text.resize(kChunksEach * kChunkBytes, '\n');
  Match match = matchOn(text, kMaxPlayers);
  for (ClientId client = 1; client <= kMaxPlayers; ++client) match.receive(client, Hello{});
  std::map<ClientId, std::uint32_t> chunks;
  for (std::uint32_t left = kMaxPlayers * kChunksEach; left > 0;) {
    match.tick();
    std::uint32_t sent = 0;
    for (const Outgoing& message : match.takeOutgoing()) {
      if (!std::holds_alternative<LevelChunk>(*decodeToClient(message.bytes))) continue;
      ++chunks[message.client];
      ++sent;
    }
    ASSERT_EQ(sent, std::min<std::uint32_t>(left, Match::kMaxChunksPerTick));
    left -= sent;
    const auto [fewest, most] = std::minmax_element(chunks.begin(), chunks.end(),
                                                    [](const auto& a, const auto& b) { return a.second < b.second; });
    if (chunks.size() == kMaxPlayers) {
      ASSERT_LE(most->second, fewest->second + 2);
    }
  }
  for (const auto& [client, count] : chunks) EXPECT_EQ(count, kChunksEach) << client;
}

TEST(MatchTransfers, AFewClientsGetTwoChunksATickEach) {
  std::string text = farGoalText();
  text.resize(10 * kChunkBytes, '\n');
  Match match = matchOn(text, 3);
  for (ClientId client = 1; client <= 3; ++client) match.receive(client, Hello{});
  match.tick();
  std::map<ClientId, std::uint32_t> chunks;
  for (const Outgoing& message : match.takeOutgoing()) {
    chunks[message.client] += std::holds_alternative<LevelChunk>(*decodeToClient(message.bytes)) ? 1 : 0;
  }
  EXPECT_EQ(chunks, (std::map<ClientId, std::uint32_t>{{1, 2}, {2, 2}, {3, 2}}));
}

}  // namespace
}  // namespace platon
