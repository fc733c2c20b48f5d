// Counts every allocation of the program: what has been played before must be played again without any.
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>
#include <string>
#include <vector>

#include "platon/game/game.h"
#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "platon/physics/rules.h"
#include "platon/physics/world.h"
#include "tests/determinism/lockstep_levels.h"
#include "tests/shared/physics/shapes.h"
#include "tests/sim/button_presses.h"

namespace {

std::size_t allocations = 0;

void* allocate(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}

}  // namespace

// The forms for arrays, and those that return null, call these.
void* operator new(std::size_t size) { return allocate(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace platon {
namespace {

constexpr std::uint64_t kSeed = 20;
constexpr std::uint32_t kPlayers = 8;
constexpr int kTicks = 2000;

/// Eight players press buttons, the same ones from the same beginning every time.
class RepeatedGame {
 public:
  explicit RepeatedGame(std::shared_ptr<const Level> level)
      : beginning_(std::move(level)), game_(beginning_), inputs_(kPlayers, Input{Input::kPresent}) {
    beginning_.advance(inputs_);  // players enter, which adds to the state
  }

  /// Returns how many allocations that took. Room for work stays with the game.
  std::size_t play() {
    game_ = beginning_;
    std::vector<sim::ButtonPresses> presses;
    for (std::uint32_t slot = 0; slot < kPlayers; ++slot) presses.emplace_back(kSeed, slot);
    std::size_t taken = 0;
    for (int tick = 0; tick < kTicks; ++tick) {
      for (std::uint32_t slot = 0; slot < kPlayers; ++slot) inputs_[slot] = presses[slot].next();
      const std::size_t before = allocations;
      game_.advance(inputs_);
      taken += allocations - before;
    }
    return taken;
  }

  std::uint64_t hash() const { return game_.hash(); }

 private:
  Game beginning_;
  Game game_;
  std::vector<Input> inputs_;
};

class AllocationTest : public testing::TestWithParam<std::string> {};

TEST_P(AllocationTest, APlayedGameIsPlayedAgainWithoutAny) {
  RepeatedGame game(sim::levelFrom(GetParam()));
  ASSERT_GT(game.play(), 0u) << "nothing is counted";
  game.play();
  const std::uint64_t hash = game.hash();
  EXPECT_EQ(game.play(), 0u) << "seed " << kSeed;
  EXPECT_EQ(game.hash(), hash) << "another game was played, seed " << kSeed;
}

// Its shapes and the hulls of its turns are made in the first round.
TEST(TurningAllocationTest, AShapeThatHasBeenAllRoundTurnsOnWithoutAny) {
  constexpr std::int32_t kTurn = 200;
  World world;
  MapPart part(world, 0);
  part.line({-50000, -5500}, {50000, -5500});
  part.initialize();
  Entity entity(world, square(5000));
  part.insert(entity, {0, 2000}, Angle());
  Rules rules;
  const auto turnRound = [&] {
    const std::size_t before = allocations;
    for (std::int32_t turned = 0; turned < Angle::kTurn; turned += kTurn) {
      entity.rotate(kTurn);
      world.solve(rules);
    }
    return allocations - before;
  };
  ASSERT_GT(turnRound(), 0u) << "nothing is counted";
  EXPECT_EQ(world.entities()[0].angle, Angle()) << "nothing was in its way";
  turnRound();
  EXPECT_EQ(turnRound(), 0u);
}

INSTANTIATE_TEST_SUITE_P(Shipped, AllocationTest, testing::ValuesIn(shippedLevels()),
                         [](const auto& file) { return sim::testName(file.param); });

}  // namespace
}  // namespace platon
