// One game against itself: saved and restored, rolled back, taken up in the middle. What is derived and not saved
// (regions, room for work) must never show in what comes next.
#include <gtest/gtest.h>

#include "platon/game/game.h"
#include "tests/determinism/lockstep_levels.h"
#include "tests/exactness/judge/run_length.h"
#include "tests/sim/churn.h"

namespace platon::sim {
namespace {

constexpr std::uint64_t kSeed = 64;
constexpr std::uint32_t kSlots = 4;
constexpr std::size_t kMaxRollback = 64;

class SyncTest : public testing::TestWithParam<std::string> {
 protected:
  std::shared_ptr<const Level> level() const { return levelFrom(GetParam()); }
};

// The inputs of a game, and what it came to.
struct Course {
  std::vector<std::vector<Input>> inputs;
  std::vector<std::vector<std::uint8_t>> states;  // before each tick
  std::vector<std::uint64_t> hashes;              // after each tick

  std::size_t ticks() const { return inputs.size(); }
};

Course courseOf(const std::shared_ptr<const Level>& level, std::int64_t ticks) {
  Game game(level);
  Churn churn(kSeed, kSlots);
  Course course;
  for (std::int64_t tick = 0; tick < ticks; ++tick) {
    course.states.push_back(game.save());
    course.inputs.push_back(churn.next());
    game.advance(course.inputs.back());
    course.hashes.push_back(game.hash());
  }
  return course;
}

TEST_P(SyncTest, AFreshGameTakesUpAnyTick) {
  const auto level = this->level();
  const Course course = courseOf(level, judge::runLength(900, 18000));
  for (std::size_t tick = 0; tick < course.ticks(); ++tick) {
    Game fresh(level);
    ASSERT_TRUE(fresh.restore(course.states[tick])) << "before tick " << tick;
    ASSERT_EQ(fresh.save(), course.states[tick]);
    fresh.advance(course.inputs[tick]);
    ASSERT_EQ(fresh.hash(), course.hashes[tick]) << "after tick " << tick << ", seed " << kSeed;
  }
}

TEST_P(SyncTest, ACopyGoesOnAsTheOriginal) {
  const auto level = this->level();
  const Course course = courseOf(level, judge::runLength(900, 18000));
  Game game(level);
  for (std::size_t tick = 0; tick < course.ticks(); ++tick) {
    Game copy = game;
    copy.advance(course.inputs[tick]);
    ASSERT_EQ(copy.hash(), course.hashes[tick]) << "after tick " << tick << ", seed " << kSeed;
    game = std::move(copy);
  }
}

// One and the same game, back by k ticks after every tick and forward again.
TEST_P(SyncTest, RolledBackByAnyNumberOfTicksItReplaysTheSame) {
  const auto level = this->level();
  const Course course = courseOf(level, judge::runLength(200, 3600));
  for (std::size_t k = 1; k <= kMaxRollback; ++k) {
    Game game(level);
    for (std::size_t tick = 0; tick < course.ticks(); ++tick) {
      const std::size_t from = tick + 1 < k ? 0 : tick + 1 - k;
      ASSERT_TRUE(game.restore(course.states[from]));
      for (std::size_t replayed = from; replayed <= tick; ++replayed) {
        game.advance(course.inputs[replayed]);
        ASSERT_EQ(game.hash(), course.hashes[replayed])
            << "back by " << k << " from tick " << tick << ", after tick " << replayed << ", seed " << kSeed;
      }
    }
  }
}

// As a client does it: ahead by k ticks on inputs that turn out wrong, then back to what was decided.
TEST_P(SyncTest, WrongPredictionsLeaveNoTrace) {
  const auto level = this->level();
  const Course course = courseOf(level, judge::runLength(400, 3600));
  Churn wrong(kSeed + 1, kSlots);
  SeededRandom random(kSeed);
  Game game(level);
  for (std::size_t tick = 0; tick < course.ticks(); ++tick) {
    for (std::uint64_t ahead = random.below(kMaxRollback); ahead > 0; --ahead) game.advance(wrong.next());
    ASSERT_TRUE(game.restore(course.states[tick]));
    game.advance(course.inputs[tick]);
    ASSERT_EQ(game.hash(), course.hashes[tick]) << "after tick " << tick << ", seed " << kSeed;
  }
}

// Somebody joins: state, then inputs, and one more player for all.
TEST_P(SyncTest, WhoJoinsInTheMiddleSeesTheSame) {
  const auto level = this->level();
  const Course course = courseOf(level, 600);
  Game server(level);
  std::vector<Game> clients;
  for (std::size_t tick = 0; tick < course.ticks(); ++tick) {
    if (tick % 60 == 0) {
      clients.emplace_back(level);
      ASSERT_TRUE(clients.back().restore(server.save()));
    }
    std::vector<Input> inputs = course.inputs[tick];
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
}  // namespace platon::sim
