// A game stays the same when it is saved and restored, copied or rolled back at any tick: derived data that is not
// saved (regions, buffers) must not change any later state.
#include <gtest/gtest.h>

#include <stdexcept>

#include "platon/game/game.h"
#include "tests/determinism/lockstep_levels.h"
#include "tests/exactness/step_check/run_length.h"
#include "tests/sim/churn.h"

namespace platon::sim::sync_test {
namespace {

constexpr std::uint64_t kSeed = 64;
constexpr std::uint32_t kSlots = 4;
constexpr std::size_t kMaxRollback = 64;

class SyncTest : public testing::TestWithParam<std::string> {
 protected:
  std::shared_ptr<const Level> level() const { return levelFrom(GetParam()); }
};

// A game as it was played, by tick.
struct History {
  std::vector<std::vector<Input>> inputs;
  std::vector<std::vector<std::uint8_t>> states;  // before each tick
  std::vector<std::uint64_t> hashes;              // after each tick

  std::size_t ticks() const { return inputs.size(); }
};

History historyOf(const std::shared_ptr<const Level>& level, std::int64_t ticks) {
  Game game(level);
  Churn churn(kSeed, kSlots);
  History history;
  for (std::int64_t tick = 0; tick < ticks; ++tick) {
    history.states.push_back(game.save());
    history.inputs.push_back(churn.next());
    game.advance(history.inputs.back());
    history.hashes.push_back(game.hash());
  }
  if (history.hashes.empty()) throw std::invalid_argument("a history without ticks tests nothing");
  return history;
}

TEST_P(SyncTest, ANewGameContinuesFromAnySavedTick) {
  const auto level = this->level();
  const History history = historyOf(level, step_check::runLength(900, 18000));
  for (std::size_t tick = 0; tick < history.ticks(); ++tick) {
    Game fresh(level);
    ASSERT_TRUE(fresh.restore(history.states[tick])) << "before tick " << tick;
    ASSERT_EQ(fresh.save(), history.states[tick]);
    fresh.advance(history.inputs[tick]);
    ASSERT_EQ(fresh.hash(), history.hashes[tick]) << "after tick " << tick << ", seed " << kSeed;
  }
}

TEST_P(SyncTest, ACopyContinuesAsTheOriginal) {
  const auto level = this->level();
  const History history = historyOf(level, step_check::runLength(900, 18000));
  Game game(level);
  for (std::size_t tick = 0; tick < history.ticks(); ++tick) {
    Game copy = game;
    copy.advance(history.inputs[tick]);
    ASSERT_EQ(copy.hash(), history.hashes[tick]) << "after tick " << tick << ", seed " << kSeed;
    game = std::move(copy);
  }
}

// Rolls one game back by k ticks after every tick and replays them; by 1, 22, 43 and 64 ticks, or at full length by any
// number of them.
TEST_P(SyncTest, ARollbackReplaysTheSameGame) {
  const auto level = this->level();
  const History history = historyOf(level, step_check::isLong() ? 3600 : 200);
  const auto step = static_cast<std::size_t>(step_check::stride(21));
  for (std::size_t k = 1; k <= kMaxRollback; k += step) {
    Game game(level);
    for (std::size_t tick = 0; tick < history.ticks(); ++tick) {
      const std::size_t from = tick + 1 < k ? 0 : tick + 1 - k;
      ASSERT_TRUE(game.restore(history.states[from]));
      for (std::size_t replayed = from; replayed <= tick; ++replayed) {
        game.advance(history.inputs[replayed]);
        ASSERT_EQ(game.hash(), history.hashes[replayed])
            << "back by " << k << " from tick " << tick << ", after tick " << replayed << ", seed " << kSeed;
      }
    }
  }
}

// Predicts up to kMaxRollback ticks with wrong inputs, as a client does, then restores the confirmed state.
TEST_P(SyncTest, WrongPredictionsDoNotChangeTheConfirmedGame) {
  const auto level = this->level();
  const History history = historyOf(level, step_check::runLength(400, 3600));
  Churn wrong(kSeed + 1, kSlots);
  SeededRandom random(kSeed);
  Game game(level);
  for (std::size_t tick = 0; tick < history.ticks(); ++tick) {
    for (std::uint64_t ahead = random.below(kMaxRollback); ahead > 0; --ahead) game.advance(wrong.next());
    ASSERT_TRUE(game.restore(history.states[tick]));
    game.advance(history.inputs[tick]);
    ASSERT_EQ(game.hash(), history.hashes[tick]) << "after tick " << tick << ", seed " << kSeed;
  }
}

// A client joins every 60 ticks: it gets the state, then inputs that include one more player.
TEST_P(SyncTest, AClientThatJoinsLateStaysInLockstep) {
  const auto level = this->level();
  const History history = historyOf(level, 600);
  Game server(level);
  std::vector<Game> clients;
  for (std::size_t tick = 0; tick < history.ticks(); ++tick) {
    if (tick % 60 == 0) {
      clients.emplace_back(level);
      ASSERT_TRUE(clients.back().restore(server.save()));
    }
    std::vector<Input> inputs = history.inputs[tick];
    inputs.resize(kSlots + clients.size(), Input{Input::kPresent | Input::kRight});
    server.advance(inputs);
    for (Game& client : clients) {
      client.advance(inputs);
      ASSERT_EQ(client.hash(), server.hash()) << "after tick " << tick << ", seed " << kSeed;
    }
  }
  EXPECT_EQ(clients.size(), 10u);
}

INSTANTIATE_TEST_SUITE_P(All, SyncTest, testing::ValuesIn(lockstepLevels()),
                         [](const auto& file) { return testName(file.param); });

}  // namespace
}  // namespace platon::sim::sync_test
