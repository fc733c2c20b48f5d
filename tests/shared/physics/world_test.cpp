#include "platon/physics/world.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <stdexcept>

#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "tests/shared/physics/maps.h"
#include "tests/shared/physics/shapes.h"
#include "tests/shared/physics/step/leg_checker.h"

namespace platon::world_test {
namespace {

constexpr std::uint64_t kSeed = 77;

// Two strips with random segments and up to four entities.
World busyWorld(std::uint64_t seed) {
  sim::SeededRandom random(seed);
  std::vector<Segment> first;
  std::vector<Segment> second;
  for (int i = 0; i < 40; ++i) {
    const Point a = random.vector(900);
    (i % 2 == 0 ? first : second).push_back({a, a + random.vector(90)});
  }
  World world = twoStrips(first, second);
  for (int i = 0; i < 40 && world.entities().size() < 4; ++i) {
    Entity entity(world, randomConvex(random, 60));
    try {
      MapPart(world, i % 2 == 0 ? 1u : 2u)
          .insert(entity, random.vector(900), Angle(static_cast<std::int32_t>(random.below(36000))));
    } catch (const std::invalid_argument&) {
    }
  }
  return world;
}

void drive(World& world, sim::SeededRandom& random) {
  for (std::uint32_t i = 0; i < world.entities().size(); ++i) {
    Entity entity(world, i);
    entity.setVelocity(random.vector(300));
    if (random.below(4) == 0) entity.rotate(static_cast<std::int32_t>(random.below(2000)) - 1000);
  }
  world.solve();
}

TEST(WorldTest, EmptyWorldsDoNotChange) {
  World world;
  world.solve();
  EXPECT_TRUE(world.entities().empty());
  EXPECT_EQ(world, World());
  EXPECT_EQ(world.hash(), World().hash());
}

TEST(WorldTest, EntitiesOutsideAllPartsDoNotMove) {
  World world;
  Entity entity(world, square(5));
  entity.setVelocity({100, 0});
  world.solve();
  EXPECT_EQ(entity.position(), Point());
  EXPECT_TRUE(world.view(0).empty());
}

TEST(WorldTest, CopiesAreIndependent) {
  World world = busyWorld(kSeed);
  const World before = world;
  World copy = world;
  sim::SeededRandom random(kSeed);
  for (int tick = 0; tick < 50; ++tick) drive(copy, random);
  EXPECT_EQ(world, before);
  EXPECT_FALSE(copy == world);
  EXPECT_EQ(&copy.geometry(), &world.geometry()) << "geometry is shared";
}

TEST(WorldTest, EqualCallsGiveEqualStates) {
  World one = busyWorld(kSeed);
  World two = busyWorld(kSeed);
  sim::SeededRandom randomOne(kSeed);
  sim::SeededRandom randomTwo(kSeed);
  for (int tick = 0; tick < 300; ++tick) {
    drive(one, randomOne);
    drive(two, randomTwo);
    ASSERT_EQ(one, two) << "seed " << kSeed << ", tick " << tick;
    ASSERT_EQ(one.hash(), two.hash());
  }
}

TEST(WorldTest, RestoredWorldsContinueIdentically) {
  World world = busyWorld(kSeed);
  sim::SeededRandom random(kSeed);
  for (int tick = 0; tick < 150; ++tick) {
    World fresh = busyWorld(kSeed);  // without regions or rotated shapes of its own
    fresh.restore(world.save());
    ASSERT_EQ(fresh, world);
    ASSERT_TRUE(fresh.accepts(world.save()));
    sim::SeededRandom same = random;
    drive(world, random);
    drive(fresh, same);
    ASSERT_EQ(fresh, world) << "seed " << kSeed << ", tick " << tick;
    ASSERT_EQ(fresh.hash(), world.hash());
  }
}

TEST(WorldTest, RewoundWorldsRepeatTheirSteps) {
  World world = busyWorld(kSeed);
  sim::SeededRandom random(kSeed);
  for (int round = 0; round < 20; ++round) {
    const World saved = world;
    sim::SeededRandom again = random;
    for (int tick = 0; tick < 10; ++tick) drive(world, random);
    const World later = world;
    world = saved;
    for (int tick = 0; tick < 10; ++tick) drive(world, again);
    ASSERT_EQ(world, later) << "seed " << kSeed << ", round " << round;
  }
}

TEST(WorldTest, MovedWorldsContinue) {
  World world = busyWorld(kSeed);
  World expected = world;
  World moved = std::move(world);
  sim::SeededRandom random(kSeed);
  sim::SeededRandom same(kSeed);
  drive(moved, random);
  drive(expected, same);
  EXPECT_EQ(moved, expected);
}

// Calls `check` after changing each integer of the state in turn.
template <class State>
void forEachChange(State& state, const std::function<void(const char*)>& check) {
  State::visit(state, [&](const char* name, auto& field) {
    const auto before = field;
    using Field = std::decay_t<decltype(field)>;
    if constexpr (std::is_same_v<Field, Point>) {
      field.x += 1;
      check(name);
      field = before;
      field.y -= 1;
    } else if constexpr (std::is_same_v<Field, Angle>) {
      field = field + Angle(1);
    } else {
      field = static_cast<Field>(field + 1);
    }
    check(name);
    field = before;
  });
}

TEST(WorldTest, EveryFieldIsHashedAndCompared) {
  World world = twoStrips();
  Entity entity(world, square(100));
  MapPart(world, 1).insert(entity, {950, 0}, Angle());
  const WorldState before = world.save();
  ASSERT_EQ(before.instances.size(), 1u);
  EXPECT_EQ(world.hash(), before.hash());
  std::set<std::uint64_t> hashes{world.hash()};
  const auto check = [&](WorldState& state, const char* name) {
    EXPECT_FALSE(state == before) << name;
    EXPECT_TRUE(hashes.insert(state.hash()).second) << name;
  };
  WorldState state = before;
  forEachChange(state.entities[0], [&](const char* name) { check(state, name); });
  forEachChange(state.instances[0], [&](const char* name) { check(state, name); });
  EXPECT_EQ(state, before);
  EXPECT_EQ(hashes.size(), 1u + 14 + 3 + 8 + 2) << "14 fields with three points, 8 fields with two points";
}

TEST(WorldTest, StatesHaveTheDocumentedSize) {
  EXPECT_LE(sizeof(EntityState), 128u);
  EXPECT_LE(sizeof(InstanceState), 32u);
}

TEST(WorldTest, AnEntityMayBeInSeveralPartsAtOnce) {
  World world;
  addPart(world, 0, {});
  addPart(world, 1, {});
  addPart(world, 2, {{{1500, -100}, {1500, 100}}});
  Entity entity(world, square(10));
  MapPart(world, 0).insert(entity, {0, 0}, Angle());
  MapPart(world, 1).insert(entity, {1000, 500}, Angle::degrees(90));
  MapPart(world, 2).insert(entity, {1400, 0}, Angle());
  entity.setVelocity({50, 20});
  world.solve();
  const auto views = world.view(0);
  ASSERT_EQ(views.size(), 3u);
  EXPECT_TRUE(views[0].home);
  EXPECT_EQ(views[0].position, Point(50, 20));
  EXPECT_EQ(views[1].position, Point(980, 550)) << "moves with the home instance, in its rotated frame";
  EXPECT_EQ(views[2].position, Point(1450, 20));
  world.solve();
  EXPECT_EQ(entity.position(), Point(90, 40)) << "the segment in part 2 stops all of them";
  EXPECT_EQ(world.view(0)[2].position, Point(1490, 40));
}

TEST(WorldTest, ErasingHomeMakesAnotherInstanceHome) {
  World world;
  for (const std::uint32_t id : {0u, 1u, 2u}) addPart(world, id, {});
  Entity entity(world, square(10));
  MapPart(world, 0).insert(entity, {0, 0}, Angle());
  MapPart(world, 1).insert(entity, {1000, 0}, Angle::degrees(90));
  MapPart(world, 2).insert(entity, {5000, 0}, Angle::degrees(180));
  entity.setVelocity({100, 7});
  world.solve();
  const auto before = world.view(0);
  MapPart(world, 0).erase(entity);
  EXPECT_TRUE(entity.inserted());
  EXPECT_EQ(entity.part(), 1u);
  EXPECT_EQ(entity.rotation(), Angle::degrees(90));
  EXPECT_EQ(entity.velocity(), Point(-7, 100));
  const auto after = world.view(0);
  ASSERT_EQ(after.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(after[i].part, before[i + 1].part);
    EXPECT_EQ(after[i].position, before[i + 1].position) << "none moves";
    EXPECT_EQ(after[i].angle, before[i + 1].angle);
  }
  world.solve();
  EXPECT_EQ(world.view(0)[0].position, after[0].position + Point(-7, 100));
  EXPECT_EQ(world.view(0)[1].position, after[1].position + Point(-100, -7));
  MapPart(world, 1).erase(entity);
  MapPart(world, 2).erase(entity);
  EXPECT_FALSE(entity.inserted());
  EXPECT_TRUE(world.view(0).empty());
}

TEST(WorldTest, InsertingNearAnEdgeAddsTheInstanceBehindIt) {
  World world = twoStrips();
  Entity entity(world, square(100));
  MapPart(world, 1).insert(entity, {950, 33}, Angle());
  const auto views = world.view(0);
  ASSERT_EQ(views.size(), 2u);
  EXPECT_EQ(views[1].part, 2u);
  EXPECT_EQ(views[1].position, Point(-1050, 33));
  EXPECT_TRUE(views[1].hasParent);
  EXPECT_EQ(views[1].parent, views[0].id);
}

TEST(WorldTest, InsertingBeyondAnEdgeRehomes) {
  World world = twoStrips();
  Entity entity(world, square(100));
  MapPart(world, 1).insert(entity, {1040, 33}, Angle());
  EXPECT_EQ(entity.part(), 2u);
  EXPECT_EQ(entity.position(), Point(-960, 33));
}

// The shape loses a vertex at many angles. The centre is on a circle around a point of the edge.
TEST(WorldTest, ATurningShapeThatLosesAVertexRehomesTwiceATurn) {
  World world;
  constexpr std::int32_t reach = 100000;
  MapPart left(world, 1);
  left.warp({reach, -reach}, {reach, reach}, 2, {-reach, -reach}, {-reach, reach});
  left.initialize();
  MapPart right(world, 2);
  right.warp({-reach, reach}, {-reach, -reach}, 1, {reach, reach}, {reach, -reach});
  right.initialize();
  const Convex shape(std::vector<Point>{{11000, -4345}, {8598, 8352}, {-10172, -2194}, {10999, -4345}});
  Entity entity(world, shape);
  left.insert(entity, {reach, 0}, Angle(18001));
  ASSERT_EQ(entity.state().crossings, 0u);
  std::size_t fewest = shape.vertices().size();
  for (int tick = 0; tick < 3600; ++tick) {
    entity.rotate(10);
    world.solve();
    fewest = std::min(fewest, world.rotatedShapeOf(0, entity.rotation())->vertices().size());
  }
  EXPECT_EQ(fewest, 3u);
  EXPECT_EQ(entity.state().crossings, 2u);
  EXPECT_EQ(entity.rotation(), Angle(18001));
}

TEST(WorldTest, SegmentsBehindAnEdgeBlockInsertion) {
  World world = twoStrips({}, {{{-980, -50}, {-980, 50}}});
  Entity entity(world, square(100));
  EXPECT_THROW(MapPart(world, 1).insert(entity, {950, 0}, Angle()), std::invalid_argument);
  EXPECT_FALSE(entity.inserted());
  MapPart(world, 1).insert(entity, {900, 0}, Angle());
  EXPECT_TRUE(entity.inserted());
}

TEST(WorldTest, RemovedEntitiesAreInNoPart) {
  World world = busyWorld(kSeed);
  World other = world;
  for (std::uint32_t i = 0; i < world.entities().size(); ++i) {
    world.erase(i);
    EXPECT_FALSE(Entity(world, i).inserted());
    EXPECT_TRUE(world.view(i).empty());
  }
  EXPECT_TRUE(world.save().instances.empty());
  EXPECT_TRUE(world.accepts(world.save()));
}

TEST(WorldTest, EntitiesDoNotCollide) {
  World world;
  addPart(world, 0, {});
  Entity one(world, square(10));
  Entity two(world, square(10));
  MapPart(world, 0).insert(one, {0, 0}, Angle());
  MapPart(world, 0).insert(two, {0, 0}, Angle());
  one.setVelocity({5, 0});
  world.solve();
  EXPECT_EQ(one.position(), Point(5, 0));
  EXPECT_EQ(two.position(), Point(0, 0));
}

TEST(WorldTest, ObserversDoNotChangeTheResult) {
  World watched = busyWorld(kSeed);
  World alone = busyWorld(kSeed);
  LegChecker checker(watched);
  sim::SeededRandom random(kSeed);
  for (int tick = 0; tick < 100; ++tick) {
    for (std::uint32_t i = 0; i < alone.entities().size(); ++i) {
      const Point velocity = random.vector(400);
      Entity(watched, i).setVelocity(velocity);
      Entity(alone, i).setVelocity(velocity);
    }
    watched.solve(&checker);
    alone.solve();
    ASSERT_EQ(watched, alone) << "seed " << kSeed << ", tick " << tick;
  }
  EXPECT_EQ(checker.faults(), "");
  EXPECT_GT(checker.legs(), 300u);
}

}  // namespace
}  // namespace platon::world_test
