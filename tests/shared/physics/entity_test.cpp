#include "platon/physics/entity.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "platon/physics/world.h"
#include "tests/shared/physics/maps.h"
#include "tests/shared/physics/shapes.h"

namespace platon {
namespace {

TEST(EntityTest, RunsTheExampleOfTheReport) {
  World world;
  intern::Convex shape;
  shape.vertices.push_back(Point(0, 0));
  shape.vertices.push_back(Point(10, 0));
  shape.vertices.push_back(Point(10, 10));
  shape.vertices.push_back(Point(0, 10));
  Entity entity(world, shape);
  EXPECT_EQ(entity.shape().vertices(), shape.vertices);
  EXPECT_EQ(world.entities().size(), 1u);
  EXPECT_FALSE(entity.inserted());
}

TEST(EntityTest, MovesInTheMapOfTheReport) {
  World world;
  MapPart face(world, 12345);
  face.line(Point(0, 0), Point(-50, 20));
  face.line(Point(-50, 20), Point(100, 80));
  face.initialize();
  intern::Convex shape;
  shape.vertices = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  Entity entity(world, shape);
  face.insert(entity, Point(-45, 60), Angle());
  Rules rules;
  world.setRules(rules);
  entity.setVelocity(Point(0, -34));
  world.solve();
  EXPECT_EQ(entity.position(), Point(-45, 26));
  // It touches the second segment, y = 20 + (x + 50) * 2 / 5, with its lower right vertex at x = -35.
  entity.setVelocity(Point(0, -1));
  world.solve();
  EXPECT_EQ(entity.position(), Point(-45, 26));
  face.erase(entity);
  EXPECT_FALSE(entity.inserted());
}

TEST(EntityTest, RejectsShapesThatAreNotConvex) {
  World world;
  intern::Convex draft;
  draft.vertices = {{0, 0}, {0, 10}, {10, 10}, {10, 0}};
  EXPECT_THROW(Entity(world, draft), std::invalid_argument);
  EXPECT_TRUE(world.entities().empty());
}

TEST(EntityTest, HandlesShareTheirState) {
  World world;
  addPart(world, 0, {});
  Entity entity(world, square(5));
  Entity same(world, entity.index());
  same.setVelocity({3, 4});
  EXPECT_EQ(entity.velocity(), Point(3, 4));
  EXPECT_EQ(&entity.world(), &world);
  Entity second(world, square(6));
  EXPECT_EQ(second.index(), 1u);
  EXPECT_EQ(second.shape(), square(6));
}

TEST(EntityTest, EqualShapesAreStoredOnce) {
  World world;
  const Entity a(world, square(5));
  const Entity b(world, square(6));
  const Entity c(world, square(5));
  EXPECT_EQ(a.state().shape, c.state().shape);
  EXPECT_NE(a.state().shape, b.state().shape);
  EXPECT_EQ(world.addShape(square(6)), b.state().shape);
}

TEST(EntityTest, AddsVelocities) {
  World world;
  Entity entity(world, square(5));
  entity.setVelocity({kVelocityLimit - 1, 1 - kVelocityLimit});
  EXPECT_EQ(entity.velocity(), Point(kVelocityLimit - 1, 1 - kVelocityLimit));
  entity.addVelocity({-kVelocityLimit, kVelocityLimit});
  EXPECT_EQ(entity.velocity(), Point(-1, 1));
}

TEST(EntityTest, VelocityRotatesAcrossAnEdge) {
  World world;
  MapPart first(world, 1);
  first.warp({1000, -5000}, {1000, 5000}, 2, {-5000, -1000}, {5000, -1000});
  first.initialize();
  MapPart second(world, 2);
  second.warp({5000, -1000}, {-5000, -1000}, 1, {1000, 5000}, {1000, -5000});
  second.initialize();
  Entity entity(world, square(10));
  MapPart(world, 1).insert(entity, {900, 70}, Angle::degrees(30));
  entity.setVelocity({60, 1});
  world.solve();
  EXPECT_EQ(entity.velocity(), Point(60, 1));
  world.solve();
  EXPECT_EQ(entity.part(), 2u);
  EXPECT_EQ(entity.velocity(), Point(1, -60));
  EXPECT_EQ(entity.rotation(), Angle::degrees(300));
  EXPECT_EQ(entity.position(), Point(72, -1020));
  EXPECT_EQ(entity.state().crossings, 1u);
}

}  // namespace
}  // namespace platon
