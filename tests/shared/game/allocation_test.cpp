// Counts the allocations of the program: a replay of what has been played before must not allocate.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "platon/game/game.h"
#include "platon/physics/entity.h"
#include "platon/physics/entity_query.h"
#include "platon/physics/map_part.h"
#include "platon/physics/query.h"
#include "platon/physics/rules.h"
#include "platon/physics/world.h"
#include "tests/determinism/lockstep_levels.h"
#include "tests/shared/physics/shapes.h"
#include "tests/sim/button_presses.h"
#include "tests/support/counted_heap.h"

namespace platon::allocation_test {
namespace {

constexpr std::uint64_t kSeed = 20;
constexpr std::uint32_t kPlayers = 8;
constexpr int kTicks = 2000;

/// A game of eight players that can be played repeatedly from the same state with the same buttons.
class RepeatedGame {
 public:
  explicit RepeatedGame(std::shared_ptr<const Level> level)
      : beginning_(std::move(level)), game_(beginning_), inputs_(kPlayers, Input{Input::kPresent}) {
    beginning_.advance(inputs_);  // adds the players
  }

  /// Plays from the beginning and returns the number of allocations. The game keeps its buffers.
  std::size_t play() {
    game_ = beginning_;
    std::vector<sim::ButtonPresses> presses;
    for (std::uint32_t slot = 0; slot < kPlayers; ++slot) presses.emplace_back(kSeed, slot);
    std::size_t taken = 0;
    for (int tick = 0; tick < kTicks; ++tick) {
      for (std::uint32_t slot = 0; slot < kPlayers; ++slot) inputs_[slot] = presses[slot].next();
      const std::size_t before = allocations();
      game_.advance(inputs_);
      taken += allocations() - before;
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

TEST_P(AllocationTest, PlayingAgainDoesNotAllocate) {
  RepeatedGame game(sim::levelFrom(GetParam()));
  ASSERT_GT(game.play(), 0u) << "allocations are not counted";
  game.play();
  const std::uint64_t hash = game.hash();
  EXPECT_EQ(game.play(), 0u) << "seed " << kSeed;
  EXPECT_EQ(game.hash(), hash) << "another game was played, seed " << kSeed;
}

// The first full turn makes the rotated shapes and the hulls of the rotations.
TEST(RotationAllocationTest, RotatingAgainDoesNotAllocate) {
  constexpr std::int32_t kTurn = 200;
  World world;
  MapPart part(world, 0);
  part.line({-50000, -5500}, {50000, -5500});
  part.initialize();
  Entity entity(world, square(5000));
  part.insert(entity, {0, 2000}, Angle());
  Rules rules;
  const auto turnRound = [&] {
    const std::size_t before = allocations();
    for (std::int32_t turned = 0; turned < Angle::kTurn; turned += kTurn) {
      entity.rotate(kTurn);
      world.setRules(rules);
      world.solve();
    }
    return allocations() - before;
  };
  ASSERT_GT(turnRound(), 0u) << "allocations are not counted";
  EXPECT_EQ(world.entities()[0].angle, Angle()) << "no segment has blocked the rotation";
  turnRound();
  EXPECT_EQ(turnRound(), 0u);
}

TEST(QueryAllocationTest, AskingAgainDoesNotAllocate) {
  World world;
  MapPart part(world, 0);
  sim::SeededRandom random(kSeed);
  for (int i = 0; i < 500; ++i) {
    const Point a = random.vector(20000);
    part.line(a, a + random.vector(2000));
  }
  part.initialize();
  for (int i = 0; i < 50; ++i) {
    Entity entity(world, square(10));
    const Point at = random.vector(20000);
    const Convex turned = *square(10).turned(Angle(700 * i));
    if (!overlapsSegment(world, 0, turned, at)) part.insert(entity, at, Angle(700 * i));
  }
  const Convex shape = square(3000);
  const Convex area = square(9000);
  EntityQuery query;
  std::vector<RayHit> rays;
  std::vector<ShapeHit> shapes;
  std::vector<SegmentRef> overlaps;
  std::vector<FoundInstance> found;
  std::vector<InstanceHit> hits;
  const auto ask = [&] {
    const std::size_t before = allocations();
    castRay(world, 0, {-15000, -15000}, {30000, 30000});
    castRayThrough(world, 0, {-15000, -15000}, {30000, 30000}, rays);
    castShape(world, 0, shape, {-15000, -15000}, {30000, 30000});
    castShapeThrough(world, 0, shape, {-15000, -15000}, {30000, 30000}, shapes);
    findOverlaps(world, 0, shape, {0, 0}, overlaps);
    query.overlapping(world, 0, area, {0, 0}, found);
    query.onRay(world, 0, {-15000, -15000}, {30000, 30000}, hits);
    return allocations() - before;
  };
  ASSERT_GT(ask(), 0u) << "allocations are not counted";
  EXPECT_EQ(ask(), 0u);
  EXPECT_GT(rays.size(), 5u);
  EXPECT_GT(shapes.size(), 50u);
  EXPECT_GT(overlaps.size(), 5u);
  EXPECT_GT(found.size(), 5u);
}

// A hazard inserts the player anew; insertions, which are no part of a step, allocate.
std::vector<std::string> levelsWithoutHazards() {
  std::vector<std::string> files = shippedLevels();
  std::erase_if(files, [](const std::string& file) {
    const auto level = sim::levelFrom(file);
    return std::any_of(level->elements.begin(), level->elements.end(),
                       [](const Element& element) { return element.kind == ElementKind::kHazard; });
  });
  return files;
}

INSTANTIATE_TEST_SUITE_P(Shipped, AllocationTest, testing::ValuesIn(levelsWithoutHazards()),
                         [](const auto& file) { return sim::testName(file.param); });

}  // namespace
}  // namespace platon::allocation_test
