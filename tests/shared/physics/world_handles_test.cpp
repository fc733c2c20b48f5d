#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "platon/physics/world.h"
#include "tests/shared/physics/maps.h"
#include "tests/shared/physics/refusal.h"
#include "tests/shared/physics/shapes.h"

namespace platon::world_handles_test {
namespace {

constexpr std::uint64_t kSeed = 11;
const std::string kReplaced = "another world was moved onto the world of this handle: make the handle again";

Entity insertedEntity(World& world, Point at) {
  Entity entity(world, square(10));
  MapPart(world, 1).insert(entity, at, Angle());
  return entity;
}

void step(World& world, Entity& entity) {
  entity.setVelocity({7, 3});
  world.solve();
}

TEST(WorldHandlesTest, HandlesFollowAWorldThatIsMoved) {
  World world = twoStrips();
  Entity entity = insertedEntity(world, {100, 0});
  MapPart part(world, 3);
  part.line({0, 0}, {5, 5});
  World moved = std::move(world);
  part.initialize();
  EXPECT_NE(moved.geometry().find(3), nullptr);
  step(moved, entity);
  EXPECT_EQ(&entity.world(), &moved);
  EXPECT_EQ(entity.position(), Point(107, 3));
  World assigned;
  assigned = std::move(moved);
  step(assigned, entity);
  EXPECT_EQ(&entity.world(), &assigned);
  EXPECT_EQ(entity.position(), Point(114, 6));
  MapPart(assigned, 1).erase(entity);
  EXPECT_FALSE(entity.inserted());
}

TEST(WorldHandlesTest, HandlesFollowTheWorldsOfAVectorAndOfASwap) {
  std::vector<World> worlds;
  std::vector<Entity> entities;
  for (std::int32_t i = 0; i < 20; ++i) {
    worlds.push_back(twoStrips());
    entities.push_back(insertedEntity(worlds.back(), {i, 0}));
  }
  std::swap(worlds[0], worlds[19]);
  EXPECT_EQ(&entities[0].world(), &worlds[19]);
  EXPECT_EQ(&entities[19].world(), &worlds[0]);
  for (std::int32_t i = 0; i < 20; ++i) EXPECT_EQ(entities[static_cast<std::size_t>(i)].position(), Point(i, 0));
}

TEST(WorldHandlesTest, HandlesStayWithAWorldThatIsCopied) {
  World world = twoStrips();
  Entity entity = insertedEntity(world, {100, 0});
  World copy = world;
  step(copy, entity);
  EXPECT_EQ(entity.position(), Point(100, 0)) << "the world of the handle was not stepped";
  Entity there(copy, entity.id());
  EXPECT_EQ(there.velocity(), Point()) << "set in the other world";
  step(copy, there);
  world = copy;
  EXPECT_EQ(&entity.world(), &world);
  EXPECT_EQ(entity.position(), Point(107, 3)) << "the state was replaced, the handle stays";
  EXPECT_EQ(refusal([&] { MapPart(world, 1).erase(there); }),
            "map part 1: entity 0 belongs to another world: use an entity of the world of this part");
}

TEST(WorldHandlesTest, RefusesHandlesOfAWorldOntoWhichAnotherWasMoved) {
  World world = twoStrips();
  Entity entity = insertedEntity(world, {100, 0});
  MapPart part(world, 3);
  for (int round = 0; round < 3; ++round) {
    World other = twoStrips();
    const Entity follows = insertedEntity(other, {round, 0});
    world = std::move(other);
    EXPECT_EQ(follows.position(), Point(round, 0));
    EXPECT_FALSE(entity.exists());
    EXPECT_EQ(refusal([&] { entity.position(); }), kReplaced);
    EXPECT_EQ(refusal([&] { entity.setVelocity({1, 1}); }), kReplaced);
    EXPECT_EQ(refusal([&] { part.initialize(); }), kReplaced);
    entity = follows;
  }
}

TEST(WorldHandlesTest, HandlesFindWhatReplacesAWorldIfNothingCanFollow) {
  World world = twoStrips();
  Entity entity = insertedEntity(world, {100, 0});
  world = World();
  EXPECT_EQ(refusal([&] { entity.position(); }), "entity 0 does not exist: the world has 0 entities, counted from 0");
}

TEST(WorldHandlesTest, AWorldThatIsMovedOntoItselfStays) {
  World world = twoStrips();
  Entity entity = insertedEntity(world, {100, 0});
  World& same = world;
  world = std::move(same);
  EXPECT_EQ(entity.position(), Point(100, 0));
}

TEST(WorldHandlesTest, ManyWorldsMayReplaceOneAfterTheOther) {
  World world;
  const Entity first(world, square(1));
  for (int round = 0; round < 100000; ++round) {
    World other;
    (void)Entity(other, square(1));
    world = std::move(other);
  }
  EXPECT_FALSE(first.exists());
}

TEST(WorldHandlesTest, RefusesHandlesOfDestroyedEntities) {
  World world = twoStrips();
  insertedEntity(world, {100, 0});
  Entity entity = insertedEntity(world, {200, 0});
  Entity copy = entity;
  entity.destroy();
  EXPECT_FALSE(copy.exists());
  EXPECT_FALSE(world.exists(1));
  EXPECT_TRUE(world.exists(0));
  const World before = world;
  const std::string destroyed = "entity 1 does not exist: it was destroyed";
  EXPECT_EQ(refusal([&] { copy.position(); }), destroyed);
  EXPECT_EQ(refusal([&] { copy.shape(); }), destroyed);
  EXPECT_EQ(refusal([&] { copy.rotate(3); }), destroyed);
  EXPECT_EQ(refusal([&] { copy.destroy(); }), destroyed);
  EXPECT_EQ(refusal([&] { MapPart(world, 1).insert(copy, {}, Angle()); }), destroyed);
  EXPECT_EQ(refusal([&] { MapPart(world, 1).erase(copy); }), destroyed);
  EXPECT_EQ(refusal([&] { world.view(1); }), destroyed);
  EXPECT_EQ(refusal([&] { world.erase(1); }), destroyed);
  EXPECT_EQ(refusal([&] { world.destroy(1); }), destroyed);
  EXPECT_EQ(refusal([&] { world.instancesOf(1); }), destroyed);
  EXPECT_EQ(refusal([&] { Entity(world, 1u).velocity(); }), destroyed);
  EXPECT_EQ(world, before);
}

TEST(WorldHandlesTest, AnIndexIsUsedAgainInALaterGeneration) {
  World world = twoStrips();
  Entity entity = insertedEntity(world, {990, 0});
  ASSERT_EQ(world.instancesOf(0).size(), 1u);
  entity.destroy();
  EXPECT_TRUE(world.save().instances.empty());
  Entity next(world, square(20));
  EXPECT_EQ(next.id(), (EntityId{0, 2}));
  EXPECT_EQ(world.idOf(0), next.id());
  EXPECT_FALSE(entity.exists());
  EXPECT_EQ(refusal([&] { entity.position(); }),
            "entity 0: the handle is stale: it has generation 0, the entity has generation 2");
  EXPECT_FALSE(next.inserted()) << "nothing is left of the destroyed entity";
  MapPart(world, 1).insert(next, {0, 0}, Angle());
  step(world, next);
  EXPECT_EQ(next.position(), Point(7, 3));
}

TEST(WorldHandlesTest, NewEntitiesGetTheLowestFreeIndex) {
  World world;
  std::vector<Entity> entities;
  for (int i = 0; i < 5; ++i) entities.emplace_back(world, square(5));
  entities[3].destroy();
  entities[1].destroy();
  EXPECT_EQ(Entity(world, square(5)).index(), 1u);
  EXPECT_EQ(Entity(world, square(5)).index(), 3u);
  EXPECT_EQ(Entity(world, square(5)).index(), 5u);
}

TEST(WorldHandlesTest, AnIndexWhoseGenerationsAreUsedUpIsNotUsedAgain) {
  World world;
  Entity entity(world, square(5));
  WorldState state = world.save();
  state.generations = {0xfffffffe};
  world.restore(state);
  Entity(world, 0u).destroy();
  EXPECT_EQ(Entity(world, square(5)).index(), 1u);
}

TEST(WorldHandlesTest, ARestoredStateBringsBackItsIds) {
  World world = twoStrips();
  Entity early = insertedEntity(world, {0, 0});
  const WorldState saved = world.save();
  early.destroy();
  Entity late(world, square(30));
  Entity other(world, square(30));
  world.restore(saved);
  EXPECT_TRUE(early.exists());
  EXPECT_EQ(early.position(), Point());
  EXPECT_EQ(refusal([&] { late.position(); }),
            "entity 0: the handle is stale: it has generation 2, the entity has generation 0");
  EXPECT_EQ(refusal([&] { other.position(); }), "entity 1 does not exist: the world has 1 entities, counted from 0");
  early.destroy();
  (void)Entity(world, square(30));
  EXPECT_TRUE(late.exists()) << "the same calls made the same entity";
}

TEST(WorldHandlesTest, GenerationsAreHashedAndCompared) {
  World world;
  (void)Entity(world, square(5));
  (void)Entity(world, square(5));
  std::set<std::uint64_t> hashes{world.hash()};
  World again = world;
  for (int i = 0; i < 4; ++i) {
    again.destroy(0);
    EXPECT_FALSE(again == world);
    EXPECT_TRUE(hashes.insert(again.hash()).second);
    (void)Entity(again, square(5));
    EXPECT_EQ(again.save().entities, world.save().entities);
    EXPECT_FALSE(again == world);
    EXPECT_TRUE(hashes.insert(again.hash()).second);
  }
}

// Entities come and go. A fresh world that is restored before every tick, without caches of its own, stays equal.
TEST(WorldHandlesTest, WorldsInWhichEntitiesComeAndGoAreDeterministic) {
  World world = twoStrips({{{-800, -300}, {800, -250}}}, {{{-800, -250}, {800, -300}}});
  const World empty = world;
  sim::SeededRandom random(kSeed);
  int reused = 0;
  for (int tick = 0; tick < 400; ++tick) {
    sim::SeededRandom same = random;
    World fresh = empty;
    for (const Convex& shape : {square(20), square(40)}) fresh.addShape(shape);
    if (tick == 0) world = fresh;
    fresh.restore(world.save());
    const auto play = [](World& played, sim::SeededRandom& choices) {
      const auto index = static_cast<std::uint32_t>(choices.below(6));
      if (played.exists(index)) played.destroy(index);
      Entity entity(played, square(choices.below(2) == 0 ? 20 : 40));
      const Point at = choices.vector(200) + Point(700, 0);
      MapPart(played, 1).insert(entity, at, Angle());
      for (std::uint32_t i = 0; i < played.entities().size(); ++i) {
        const Point velocity = choices.vector(100);
        if (played.exists(i)) Entity(played, i).setVelocity(velocity);
      }
      played.solve();
      return entity.id().generation;
    };
    reused += play(world, random) != 0 ? 1 : 0;
    play(fresh, same);
    ASSERT_EQ(fresh, world) << "seed " << kSeed << ", tick " << tick;
    ASSERT_EQ(fresh.hash(), world.hash());
    ASSERT_EQ(world.fault(world.save()), std::nullopt);
  }
  EXPECT_GT(reused, 100);
}

}  // namespace
}  // namespace platon::world_handles_test
