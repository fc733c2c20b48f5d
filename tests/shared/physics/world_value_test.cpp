// A world is a value: it can be compared, saved and restored.
#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>
#include <string>

#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "platon/physics/world.h"
#include "tests/shared/physics/maps.h"
#include "tests/shared/physics/refusal.h"
#include "tests/shared/physics/shapes.h"

namespace platon::world_value_test {
namespace {

// A strip with this segment and an entity with this shape in it.
World stripWith(const Segment& segment, const Convex& shape) {
  World world = twoStrips({segment});
  Entity entity(world, shape);
  MapPart(world, 1).insert(entity, {0, 0}, Angle());
  return world;
}

TEST(WorldValueTest, EqualStatesOnDifferentMapsAreNotEqual) {
  const Segment wall{{500, -500}, {500, 500}};
  const World world = stripWith(wall, square(10));
  EXPECT_EQ(world, stripWith(wall, square(10))) << "built alike";
  const World other = stripWith({{501, -500}, {501, 500}}, square(10));
  ASSERT_EQ(world.save(), other.save());
  EXPECT_FALSE(world == other);
  EXPECT_FALSE(world == stripWith({wall.b, wall.a}, square(10))) << "contacts would name other ends";
  World extended = world;
  addPart(extended, 3, {});
  ASSERT_EQ(world.save(), extended.save());
  EXPECT_FALSE(world == extended) << "another part";
}

// The result of save() was a reference: what a program had saved changed with the world.
TEST(WorldValueTest, WhatWasSavedDoesNotChange) {
  World world = stripWith({{500, -500}, {500, 500}}, square(10));
  Entity entity(world, 0u);
  entity.setVelocity({5, 0});
  const WorldState& live = world.state();
  const auto& saved = world.save();
  world.solve();
  EXPECT_EQ(live.entities[0].position, Point(5, 0));
  EXPECT_EQ(saved.entities[0].position, Point(0, 0));
  world.restore(saved);
  EXPECT_EQ(entity.position(), Point(0, 0));
}

TEST(WorldValueTest, EqualStatesOnDifferentWarpsAreNotEqual) {
  const auto withTarget = [](std::uint32_t target) {
    World world;
    MapPart part(world, 1);
    part.warp({1000, -5000}, {1000, 5000}, target, {-1000, -5000}, {-1000, 5000});
    part.initialize();
    return world;
  };
  EXPECT_EQ(withTarget(2), withTarget(2));
  EXPECT_FALSE(withTarget(2) == withTarget(3));
}

TEST(WorldValueTest, EqualStatesOfDifferentShapesAreNotEqual) {
  const Segment wall{{500, -500}, {500, 500}};
  const World world = stripWith(wall, square(10));
  const World other = stripWith(wall, square(11));
  ASSERT_EQ(world.save(), other.save());
  EXPECT_FALSE(world == other);
  World more = world;
  more.addShape(square(12));
  ASSERT_EQ(world.save(), more.save());
  EXPECT_FALSE(world == more) << "a state with this shape could be restored in one of them only";
}

// One of them is in both strips.
World fourEntities() {
  World world = twoStrips();
  for (const std::int32_t x : {-500, 0, 500, 950}) {
    Entity entity(world, square(100));
    MapPart(world, 1).insert(entity, {x, 0}, Angle());
  }
  return world;
}

TEST(WorldValueTest, RestoreRefusesWhatIsNotAccepted) {
  World world = fourEntities();
  const World before = world;
  const auto refusal = [&](const std::function<void(WorldState&)>& change) {
    WorldState state = before.save();
    change(state);
    try {
      world.restore(state);
    } catch (const std::invalid_argument& reason) {
      EXPECT_EQ(world, before) << "nothing changes";
      return std::string(reason.what());
    }
    return std::string();
  };
  EXPECT_EQ(refusal([](WorldState& state) { state.entities[2].shape = 99; }),
            "the state does not fit this world: entity 2: the world has no such shape");
  EXPECT_EQ(
      refusal([](WorldState& state) { state.entities[1].velocity.x = kVelocityLimit; }),
      "the state does not fit this world: entity 1: velocity is out of range: its coordinates must be below 2^28 in "
      "magnitude");
  EXPECT_EQ(refusal([](WorldState& state) { state.entities[0].part = 7; }),
            "the state does not fit this world: entity 0: its map part is not initialised");
  EXPECT_EQ(refusal([](WorldState& state) { state.instances.push_back({}); }),
            "the state does not fit this world: the state has more further instances than its entities name");
  EXPECT_EQ(refusal([](WorldState& state) { state.entities[3].position = {5, 6}; }), "");
  EXPECT_EQ(world.entities()[3].position, Point(5, 6));
}

TEST(WorldValueTest, RestoreUncheckedReplacesTheState) {
  World world = fourEntities();
  const WorldState saved = world.save();
  Entity(world, 2).setVelocity({3, 4});
  world.solve();
  ASSERT_NE(world.save(), saved);
  world.restoreUnchecked(saved);
  EXPECT_EQ(world.save(), saved);
  EXPECT_EQ(world, fourEntities());
}

TEST(WorldValueTest, RefusesEntitiesThatDoNotExist) {
  World world = twoStrips();
  Entity entity(world, square(5));
  const auto refuses = [](const std::function<void()>& call) {
    return refusal(call) == "entity 1 does not exist: the world has 1 entities, counted from 0";
  };
  const World before = world;
  EXPECT_TRUE(refuses([&] { world.instancesOf(1); }));
  EXPECT_TRUE(refuses([&] { world.positionOf(1, InstanceState()); }));
  EXPECT_TRUE(refuses([&] { world.shapeOf(1); }));
  EXPECT_TRUE(refuses([&] { world.rotatedShapeOf(1, Angle(1)); }));
  EXPECT_TRUE(refuses([&] { world.view(1); }));
  EXPECT_TRUE(refuses([&] { world.erase(1); }));
  EXPECT_EQ(world, before);
}

}  // namespace
}  // namespace platon::world_value_test
