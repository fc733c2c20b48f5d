#include "server/match/transfer.h"

#include <gtest/gtest.h>

#include <numeric>

#include "protocol/assembly.h"
#include "tests/support/test_levels.h"

namespace platon {
namespace {

TEST(Transfer, SendsAWholeLevelInPieces) {
  const LevelPointer level = levelOf(farGoalText() + "#" + std::string(10000, 'x') + "\n");
  Transfer transfer(level);
  EXPECT_TRUE(transfer.isLevel(level->hash));
  EXPECT_FALSE(transfer.isLevel(level->hash + 1));
  Assembly assembly;
  bool done = false;
  int pieces = 0;
  for (; !transfer.done(); ++pieces) {
    const auto piece = std::get<LevelChunk>(*decodeToClient(transfer.nextPiece()));
    EXPECT_EQ(piece.hash, level->hash);
    done = assembly.add(piece.total, piece.offset, piece.bytes);
  }
  EXPECT_EQ(pieces, 3);
  EXPECT_TRUE(done);
  EXPECT_EQ(std::string(assembly.bytes().begin(), assembly.bytes().end()), level->text);
}

TEST(Transfer, SendsAWholeStateInPieces) {
  std::vector<std::uint8_t> state(2 * kChunkBytes);
  std::iota(state.begin(), state.end(), std::uint8_t{0});
  Transfer transfer(3, 500, 2, state);
  EXPECT_TRUE(transfer.isState());
  Assembly assembly;
  for (const bool last : {false, true}) {
    ASSERT_FALSE(transfer.done());
    const auto piece = std::get<StateChunk>(*decodeToClient(transfer.nextPiece()));
    EXPECT_EQ(piece.round, 3u);
    EXPECT_EQ(piece.tick, 500u);
    EXPECT_EQ(piece.sync, 2);
    EXPECT_EQ(assembly.add(piece.total, piece.offset, piece.bytes), last);
  }
  EXPECT_TRUE(transfer.done());
  EXPECT_EQ(assembly.bytes(), state);
}

}  // namespace
}  // namespace platon
