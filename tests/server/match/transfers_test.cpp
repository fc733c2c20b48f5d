#include "server/match/transfers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <variant>

#include "protocol/to_client.h"
#include "protocol/transfer.h"
#include "server/match/match.h"
#include "server/match/updates.h"
#include "tests/support/test_levels.h"

namespace platon::transfers_test {
namespace {

TEST(Transfer, SendsAWholeLevelInChunks) {
  const LevelPointer level = levelOf(farGoalText() + "#" + std::string(10000, 'x') + "\n");
  Transfer transfer(level);
  EXPECT_FALSE(transfer.isState());
  EXPECT_TRUE(transfer.isSameLevel(Transfer(level)));
  EXPECT_FALSE(transfer.isSameLevel(Transfer(levelOf(farGoalText()))));
  Assembly assembly;
  bool done = false;
  int chunks = 0;
  for (; !transfer.done(); ++chunks) {
    const auto chunk = std::get<LevelChunk>(*decodeToClient(transfer.nextChunk()));
    EXPECT_EQ(chunk.hash, level->hash);
    done = assembly.add(chunk.total, chunk.offset, chunk.bytes);
  }
  EXPECT_EQ(chunks, 10);
  EXPECT_TRUE(done);
  EXPECT_EQ(std::string(assembly.bytes().begin(), assembly.bytes().end()), level->text);
}

TEST(Transfer, SendsAWholeStateInChunks) {
  std::vector<std::uint8_t> state(2 * kChunkBytes);
  std::iota(state.begin(), state.end(), std::uint8_t{0});
  Transfer transfer(3, 500, 2, SharedBytes(state));
  EXPECT_TRUE(transfer.isState());
  EXPECT_FALSE(transfer.isSameLevel(transfer));
  Assembly assembly;
  for (const bool last : {false, true}) {
    ASSERT_FALSE(transfer.done());
    const auto chunk = std::get<StateChunk>(*decodeToClient(transfer.nextChunk()));
    EXPECT_EQ(chunk.round, 3u);
    EXPECT_EQ(chunk.tick, 500u);
    EXPECT_EQ(chunk.sync, 2);
    EXPECT_EQ(assembly.add(chunk.total, chunk.offset, chunk.bytes), last);
  }
  EXPECT_TRUE(transfer.done());
  EXPECT_EQ(assembly.bytes(), state);
}

TEST(Transfer, CopiesShareTheirMessages) {
  Transfer first(levelOf(farGoalText() + "#" + std::string(10000, 'x') + "\n"));
  Transfer second = first;
  const SharedBytes chunk = first.nextChunk();
  EXPECT_EQ(second.nextChunk().data(), chunk.data());
  EXPECT_NE(second.nextChunk().data(), chunk.data());
}

bool shareMessages(Transfer a, Transfer b) { return a.nextChunk().data() == b.nextChunk().data(); }

LevelPointer levelOfNumber(int number) { return levelOf("# title: " + std::to_string(number) + "\n" + farGoalText()); }

TEST(TransferCache, TransfersOfALevelShareTheirMessages) {
  TransferCache cache;
  Transfer first = cache.level(levelOfNumber(1));
  first.nextChunk();
  EXPECT_FALSE(cache.level(levelOfNumber(1)).done()) << "each begins with the first chunk";
  EXPECT_TRUE(shareMessages(cache.level(levelOfNumber(1)), cache.level(levelOfNumber(1))));
  EXPECT_FALSE(cache.level(levelOfNumber(1)).isSameLevel(cache.level(levelOfNumber(2))));
}

TEST(TransferCache, KeepsTheMessagesOfTwoLevels) {
  TransferCache cache;
  const Transfer first = cache.level(levelOfNumber(1));
  cache.level(levelOfNumber(2));
  EXPECT_TRUE(shareMessages(first, cache.level(levelOfNumber(1))));
  cache.level(levelOfNumber(3));
  EXPECT_FALSE(shareMessages(first, cache.level(levelOfNumber(1))));
}

TEST(TransferCache, TransfersOfAStateShareTheirMessages) {
  TransferCache cache;
  Game game(levelOf(farGoalText()));
  TickHistory history(7, shortHash(game.hash()));
  const Transfer first = cache.state(7, history, game, 1);
  EXPECT_TRUE(shareMessages(first, cache.state(7, history, game, 1)));
  EXPECT_FALSE(shareMessages(first, cache.state(7, history, game, 2))) << "the number is part of the messages";
  EXPECT_FALSE(shareMessages(first, cache.state(8, history, game, 1)));
}

TEST(TransferCache, EachTickHasAStateOfItsOwn) {
  TransferCache cache;
  Game game(levelOf(farGoalText()));
  TickHistory history(1, shortHash(game.hash()));
  const std::vector<Input> inputs{Input{Input::kPresent | Input::kRight}};
  for (std::uint32_t tick = 0; tick < 3; ++tick) {
    Transfer transfer = cache.state(1, history, game, 5);
    const auto chunk = std::get<StateChunk>(*decodeToClient(transfer.nextChunk()));
    EXPECT_TRUE(transfer.done());
    EXPECT_EQ(chunk.round, 1u);
    EXPECT_EQ(chunk.tick, tick);
    EXPECT_EQ(chunk.sync, 5);
    EXPECT_EQ(decodeFullState(chunk.bytes), (FullState{history.held(), game.save()}));
    game.advance(inputs);
    history.append(inputs, shortHash(game.hash()));
  }
}

class ClientTransfersTest : public testing::Test {
 protected:
  // Number of level texts among the messages of all transfers.
  std::uint32_t takeLevels() {
    std::uint32_t levels = 0;
    for (auto chunk = transfers_.nextChunk(); chunk; chunk = transfers_.nextChunk()) {
      levels += std::holds_alternative<LevelChunk>(*decodeToClient(*chunk)) ? 1 : 0;
    }
    return levels;
  }

  ClientTransfers transfers_;
};

TEST_F(ClientTransfersTest, StatesAreASecondApart) {
  EXPECT_TRUE(transfers_.maySendState(0));
  transfers_.sendState(Transfer(1, 30, 1, SharedBytes({1, 2, 3})), 100);
  EXPECT_FALSE(transfers_.maySendState(159));
  EXPECT_TRUE(transfers_.maySendState(160));
}

TEST_F(ClientTransfersTest, NumbersOfStatesSkipZero) {
  for (int i = 0; i < 256; ++i) transfers_.sendState(Transfer(1, 1, transfers_.nextSync(), SharedBytes({1})), 0);
  const auto chunk = transfers_.nextChunk();
  ASSERT_TRUE(chunk);
  EXPECT_EQ(std::get<StateChunk>(*decodeToClient(*chunk)).sync, 1);
  EXPECT_FALSE(transfers_.nextChunk());  // a new state replaces the transfer of the last one
}

TEST_F(ClientTransfersTest, ALevelInTransferIsNotSentTwice) {
  const LevelPointer level = levelOf(farGoalText());
  transfers_.sendLevel(Transfer(level));
  transfers_.sendLevel(Transfer(level));
  EXPECT_EQ(takeLevels(), 1u);
}

TEST_F(ClientTransfersTest, LevelsPerRoundAreLimited) {
  const LevelPointer level = levelOf(farGoalText());
  std::uint32_t levels = 0;
  for (std::uint32_t i = 0; i < 2 * ClientTransfers::kMaxLevelsPerRound; ++i) {
    transfers_.sendLevel(Transfer(level));
    levels += takeLevels();
  }
  EXPECT_EQ(levels, ClientTransfers::kMaxLevelsPerRound);
  transfers_.startRound();
  transfers_.sendLevel(Transfer(level));
  EXPECT_EQ(takeLevels(), 1u);
}

Match matchOn(const std::string& text, std::uint32_t maxPlayers, MatchProgram program = {}) {
  return Match(LevelRotation({levelOf(text)}), {maxPlayers, "Test"}, std::move(program));
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
    ASSERT_EQ(sent, std::min<std::uint32_t>(left, MatchTransfers::kMaxChunksPerTick));
    left -= sent;
    const auto [fewest, most] = std::minmax_element(chunks.begin(), chunks.end(),
                                                    [](const auto& a, const auto& b) { return a.second < b.second; });
    if (chunks.size() == kMaxPlayers) {
      ASSERT_LE(most->second, fewest->second + MatchTransfers::kClientChunksPerTick);
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
  std::map<ClientId, std::size_t> room{{1, 3}, {2, 0}};
  Match match = matchOn(text, 2, {.room = [&](ClientId client) { return room[client]; }});
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
}  // namespace platon::transfers_test
