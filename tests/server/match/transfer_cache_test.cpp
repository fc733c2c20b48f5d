#include "server/match/transfer_cache.h"

#include <gtest/gtest.h>

#include <string>

#include "protocol/full_state.h"
#include "protocol/to_client.h"
#include "tests/support/test_levels.h"

namespace platon::transfer_cache_test {
namespace {

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

}  // namespace
}  // namespace platon::transfer_cache_test
