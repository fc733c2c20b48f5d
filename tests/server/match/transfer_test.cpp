#include "server/match/transfer.h"

#include <gtest/gtest.h>

#include <numeric>

#include "protocol/assembly.h"
#include "protocol/to_client.h"
#include "tests/support/test_levels.h"

namespace platon::transfer_test {
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

}  // namespace
}  // namespace platon::transfer_test
