// Several games and worlds in one process do not influence each other: interleaved, on threads that share static
// geometry, and with entities in a different order.
#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

#include "platon/game/game.h"
#include "platon/physics/map_part.h"
#include "tests/determinism/lockstep_levels.h"
#include "tests/sim/churn.h"

namespace platon::sim::worlds_test {
namespace {

constexpr std::uint64_t kSeed = 17;
constexpr std::uint32_t kSlots = 4;

class WorldsTest : public testing::TestWithParam<std::string> {
 protected:
  std::shared_ptr<const Level> level() const { return levelFrom(GetParam()); }
};

std::vector<std::uint64_t> hashesOf(const std::shared_ptr<const Level>& level, std::uint64_t seed, int ticks) {
  Game game(level);
  Churn churn(seed, kSlots);
  std::vector<std::uint64_t> hashes;
  for (int tick = 0; tick < ticks; ++tick) {
    game.advance(churn.next());
    hashes.push_back(game.hash());
  }
  return hashes;
}

// Five games on one level advance alternately, a few ticks each, and between them another game with other inputs.
TEST_P(WorldsTest, InterleavedGamesDoNotInfluenceEachOther) {
  const auto level = this->level();
  const auto alone = hashesOf(level, kSeed, 600);
  struct Turn {
    Game game;
    Churn churn{kSeed, kSlots};
  };
  std::vector<Turn> turns(5, Turn{Game(level)});
  Game other(level);
  Churn otherChurn(kSeed + 1, kSlots);
  SeededRandom random(kSeed);
  std::vector<std::size_t> played(turns.size());
  while (std::any_of(played.begin(), played.end(), [&](std::size_t ticks) { return ticks < alone.size(); })) {
    const auto index = random.below(turns.size());
    other.advance(otherChurn.next());
    for (std::uint64_t left = random.below(9); left > 0 && played[index] < alone.size(); --left) {
      turns[index].game.advance(turns[index].churn.next());
      ASSERT_EQ(turns[index].game.hash(), alone[played[index]++]) << "game " << index << ", seed " << kSeed;
    }
  }
}

// Threads share the static geometry of a level, its rotated shapes and its grid; each has its own world.
TEST_P(WorldsTest, ThreadsThatShareALevelAgree) {
  const auto level = this->level();
  const auto alone = hashesOf(level, kSeed, 600);
  std::vector<std::vector<std::uint64_t>> found(4);
  std::vector<std::thread> threads;
  for (auto& hashes : found) threads.emplace_back([&] { hashes = hashesOf(level, kSeed, 600); });
  for (std::thread& thread : threads) thread.join();
  for (const auto& hashes : found) EXPECT_EQ(hashes, alone);
}

// Entities do not collide with each other, so that their order changes only the hash.
TEST_P(WorldsTest, EntitiesMoveTheSameInAnyOrder) {
  const auto level = this->level();
  const auto flung = [&](const std::vector<std::uint32_t>& order) {
    World world = level->world;
    std::vector<SeededRandom> randoms;
    for (const std::uint32_t name : order) {
      Entity entity(world, playerShape());
      MapPart(world, level->startFace).insert(entity, level->start, level->startAngle);
      randoms.emplace_back(kSeed + name);
    }
    for (int tick = 0; tick < 200; ++tick) {
      for (std::uint32_t i = 0; i < order.size(); ++i) Entity(world, i).setVelocity(randoms[i].vector(20000));
      world.solve();
    }
    std::vector<EntityState> byName(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) byName[order[i]] = world.entities()[i];
    return byName;
  };
  const auto inOrder = flung({0, 1, 2, 3, 4, 5});
  EXPECT_EQ(flung({5, 4, 3, 2, 1, 0}), inOrder);
  EXPECT_EQ(flung({3, 0, 5, 1, 4, 2}), inOrder);
}

// Without doors, a player's path does not depend on the other players, on its slot, or on when others join.
TEST_P(WorldsTest, APlayerMovesTheSameWithAnyOtherPlayers) {
  const auto level = this->level();
  if (level->doorNumbers != 0) GTEST_SKIP() << "doors open for everybody";
  const auto pathOf = [&](std::uint32_t slot, std::uint32_t slots) {
    Game game(level);
    Churn churn(kSeed, slots);
    ButtonPresses own(kSeed, 99);
    std::vector<EntityState> path;
    for (int tick = 0; tick < 600; ++tick) {
      std::vector<Input> inputs = churn.next();
      inputs[slot] = own.next();
      game.advance(inputs);
      path.push_back(game.world().entities()[slot]);
    }
    return path;
  };
  const auto alone = pathOf(0, 1);
  EXPECT_EQ(pathOf(0, 8), alone);
  EXPECT_EQ(pathOf(5, 8), alone);
}

INSTANTIATE_TEST_SUITE_P(All, WorldsTest, testing::ValuesIn(lockstepLevels()),
                         [](const auto& file) { return testName(file.param); });

}  // namespace
}  // namespace platon::sim::worlds_test
