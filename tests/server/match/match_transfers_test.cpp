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

// 128 clients join within half a second, four in each tick.
TEST(MatchTransfers, ChangedNamesAreSentAtMostFourTimesASecond) {
  Match match = matchOn(farGoalText(), kMaxPlayers);
  std::map<ClientId, std::map<std::uint32_t, std::string>> names;
  std::map<ClientId, int> rosters;
  for (std::uint32_t tick = 0; tick < 4 * Match::kRosterTicks; ++tick) {
    for (ClientId i = 1; i <= 4 && tick < 32; ++i) match.receive(4 * tick + i, Hello{});
    match.tick();
    for (const Outgoing& message : match.takeOutgoing()) {
      const auto decoded = decodeToClient(message.bytes);
      const Roster* roster = std::get_if<Roster>(&*decoded);
      if (!roster) continue;
      ++rosters[message.client];
      for (const RosterEntry& entry : roster->entries) names[message.client][entry.slot] = entry.name;
    }
  }
  EXPECT_EQ(names.size(), 128u);
  for (const auto& [client, known] : names) EXPECT_EQ(known.size(), 128u) << client;
  EXPECT_EQ(rosters[1], 1 + 4) << "all at first, then the changes";
  EXPECT_LE(rosters[128], 2 + 1) << "two messages hold all names";
}

TEST(MatchTransfers, ClientsThatJoinInOneTickShareTheMessages) {
  Match match = matchOn(farGoalText(), 3);
  match.receive(1, Hello{});
  match.tick();
  match.takeOutgoing();
  match.receive(2, Hello{});
  match.receive(3, Hello{});
  match.tick();
  std::map<ClientId, std::vector<const std::uint8_t*>> chunks;
  for (const Outgoing& message : match.takeOutgoing()) {
    const auto decoded = decodeToClient(message.bytes);
    const bool chunk = std::holds_alternative<LevelChunk>(*decoded) || std::holds_alternative<StateChunk>(*decoded);
    if (chunk && message.client != 1) chunks[message.client].push_back(message.bytes.data());
  }
  EXPECT_EQ(chunks[2].size(), 2u);
  EXPECT_EQ(chunks[2], chunks[3]);
}

}  // namespace
}  // namespace platon
