#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "server/match/match.h"
#include "tests/support/test_levels.h"

namespace platon::match_transfers_test {
namespace {

Match matchOn(const std::string& text, std::uint32_t maxPlayers) {
  return Match(LevelRotation({levelOf(text)}), {maxPlayers, "Test"});
}

// All clients together get kMaxChunksPerTick chunks a tick, in turns, until each has the whole level.
TEST(MatchTransfers, SendsABoundedNumberOfChunksPerTick) {
  constexpr std::uint32_t kChunksEach = 40;
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
      ASSERT_LE(most->second, fewest->second + Match::kClientChunksPerTick);
    }
  }
  for (const auto& [client, count] : chunks) EXPECT_EQ(count, kChunksEach) << client;
}

TEST(MatchTransfers, AFewClientsGetEightChunksATickEach) {
  std::string text = farGoalText();
  text.resize(10 * kChunkBytes, '\n');
  Match match = matchOn(text, 3);
  for (ClientId client = 1; client <= 3; ++client) match.receive(client, Hello{});
  match.tick();
  std::map<ClientId, std::uint32_t> chunks;
  for (const Outgoing& message : match.takeOutgoing()) {
    chunks[message.client] += std::holds_alternative<LevelChunk>(*decodeToClient(message.bytes)) ? 1 : 0;
  }
  EXPECT_EQ(chunks, (std::map<ClientId, std::uint32_t>{{1, 8}, {2, 8}, {3, 8}}));
}

// A client that acknowledges nothing must not fill the memory of the server.
TEST(MatchTransfers, ChunksWaitForAClientWithoutRoom) {
  std::string text = farGoalText();
  text.resize(10 * kChunkBytes, '\n');
  Match match = matchOn(text, 2);
  std::map<ClientId, std::size_t> room{{1, 3}, {2, 0}};
  match.setRoom([&](ClientId client) { return room[client]; });
  for (ClientId client = 1; client <= 2; ++client) match.receive(client, Hello{});
  const auto chunksInATick = [&match] {
    match.tick();
    std::map<ClientId, std::uint32_t> chunks;
    for (const Outgoing& message : match.takeOutgoing()) {
      if (std::holds_alternative<LevelChunk>(*decodeToClient(message.bytes))) ++chunks[message.client];
    }
    return chunks;
  };
  EXPECT_EQ(chunksInATick(), (std::map<ClientId, std::uint32_t>{{1, 3}}));
  room[2] = 1;
  EXPECT_EQ(chunksInATick(), (std::map<ClientId, std::uint32_t>{{1, 3}, {2, 1}}));
}

// 128 clients join within half a second, four in each tick.
TEST(MatchTransfers, ChangedNamesAreSentAtMostFourTimesASecond) {
  Match match = matchOn(farGoalText(), kMaxPlayers);
  std::map<ClientId, std::map<std::uint32_t, std::string>> names;
  std::map<ClientId, std::set<std::uint32_t>> ticksWithNames;
  for (std::uint32_t tick = 0; tick < 4 * Match::kRosterTicks; ++tick) {
    for (ClientId i = 1; i <= 4 && tick < 32; ++i) match.receive(4 * tick + i, Hello{});
    match.tick();
    for (const Outgoing& message : match.takeOutgoing()) {
      const auto decoded = decodeToClient(message.bytes);
      const Roster* roster = std::get_if<Roster>(&*decoded);
      if (!roster) continue;
      ticksWithNames[message.client].insert(tick);
      for (const RosterEntry& entry : roster->entries) names[message.client][entry.slot] = entry.name;
    }
  }
  EXPECT_EQ(names.size(), 128u);
  for (const auto& [client, known] : names) EXPECT_EQ(known.size(), 128u) << client;
  EXPECT_EQ(ticksWithNames[1].size(), 4u);
  EXPECT_LE(ticksWithNames[128].size(), 2u);
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
}  // namespace platon::match_transfers_test
