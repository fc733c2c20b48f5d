#include "platon/physics/entity.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <stdexcept>
#include <string>

#include "platon/physics/map_part.h"
#include "platon/physics/world.h"
#include "tests/shared/physics/maps.h"
#include "tests/shared/physics/refusal.h"
#include "tests/shared/physics/shapes.h"

namespace platon::entity_test {
namespace {

constexpr std::uint64_t kSeed = 12;

TEST(EntityTest, RejectsShapesThatAreNotConvex) {
  World world;
  intern::Convex draft;
  draft.vertices = {{0, 0}, {0, 10}, {10, 10}, {10, 0}};
  EXPECT_THROW((void)Entity(world, draft), std::invalid_argument);
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

TEST(EntityTest, AddingVelocityKeepsTheHeading) {
  World world;
  Entity entity(world, square(5));
  entity.setVelocity({1000003, -7}, Angle(3600));
  entity.addVelocity({0, 100});
  EXPECT_EQ(entity.heading(), Angle(3600));
  EXPECT_EQ(entity.state().velocity, Point(1000003 + 59, -7 + 81)) << "(58.8, 80.9): only the change is rounded";
}

TEST(EntityTest, AddingZeroVelocityChangesNothing) {
  World world;
  Entity entity(world, square(5));
  for (std::int32_t frame = 0; frame < Angle::kTurn; frame += 100) {
    entity.setVelocity({12345, -678}, Angle(frame));
    const EntityState before = entity.state();
    entity.addVelocity({});
    entity.addVelocity({}, Angle(77));
    ASSERT_EQ(entity.state(), before) << frame;
  }
}

TEST(EntityTest, AddingVelocityAndItsNegativeRestoresTheState) {
  World world;
  Entity entity(world, square(5));
  sim::SeededRandom random(kSeed);
  for (int i = 0; i < 5000; ++i) {
    const Point velocity = random.vector(1 << 20);
    entity.setVelocity(velocity, Angle(static_cast<std::int32_t>(random.below(Angle::kTurn))));
    const EntityState before = entity.state();
    const Point change = random.vector(2 << (i % 20));
    const Angle frame(static_cast<std::int32_t>(random.below(Angle::kTurn)));
    entity.addVelocity(change, frame);
    entity.addVelocity(-change, frame);
    ASSERT_EQ(entity.state(), before) << "seed " << kSeed << ", round " << i;
  }
}

// The bound is n / 2 for the rounding of the additions and n * |change| * 2^-28 for the rotation.
TEST(EntityTest, ManyAdditionsOfVelocityDriftByAtMostHalfASubunitEach) {
  World world;
  Entity entity(world, square(5));
  sim::SeededRandom random(kSeed);
  constexpr std::int64_t one = std::int64_t{1} << Rotation::kFractionBits;
  constexpr std::int64_t additions = 1000;
  for (int i = 0; i < 200; ++i) {
    const Angle heading(static_cast<std::int32_t>(random.below(Angle::kTurn)));
    const Point change = random.vector(300);
    entity.setVelocity({}, heading);
    for (std::int64_t n = 0; n < additions; ++n) entity.addVelocity(change);
    const WideVector exact = rotateWide(change, rotationOf(-heading));
    const Point sum = entity.state().velocity;
    ASSERT_LE(std::abs(sum.x * one - additions * exact.x), additions * one / 2) << "seed " << kSeed << ", round " << i;
    ASSERT_LE(std::abs(sum.y * one - additions * exact.y), additions * one / 2) << "seed " << kSeed << ", round " << i;
  }
}

TEST(EntityTest, AdditionsInTheHeadingAreExact) {
  World world;
  Entity entity(world, square(5));
  for (std::int32_t frame = 0; frame < Angle::kTurn; frame += 7) {
    entity.setVelocity({}, Angle(frame));
    for (int n = 0; n < 100; ++n) entity.addVelocity({3, -17}, entity.heading());
    ASSERT_EQ(entity.state().velocity, Point(300, -1700)) << frame;
    entity.addVelocity({3, -17}, entity.heading() + Angle::degrees(90));
    ASSERT_EQ(entity.state().velocity, Point(317, -1697)) << frame;
    ASSERT_EQ(entity.heading(), Angle(frame));
  }
}

// A body that left the coordinates stopped, and nothing told.
TEST(EntityTest, TellsThatItIsAtTheLimitOfTheCoordinates) {
  constexpr std::int32_t last = kCoordinateLimit - 1;
  for (const Angle frame : {Angle(), Angle(9000), Angle(18000), Angle(27000), Angle(1234)}) {
    World world;
    addPart(world, 0, {});
    Entity entity(world, square(5));
    EXPECT_FALSE(entity.isAtLimit()) << "in no part";
    MapPart(world, 0).insert(entity, {0, 0}, Angle());
    entity.setVelocity({kVelocityLimit - 1, 0}, frame);
    world.solve();
    EXPECT_FALSE(entity.isAtLimit());
    for (int tick = 0; tick < 3; ++tick) world.solve();
    EXPECT_TRUE(entity.isAtLimit()) << frame.centidegrees();
    EXPECT_EQ(maxNorm(entity.position()), last) << frame.centidegrees();
    entity.setVelocity({-9, 0}, frame);
    world.solve();
    EXPECT_FALSE(entity.isAtLimit()) << frame.centidegrees();
  }
}

TEST(EntityTest, IsAtTheLimitWhereAFurtherInstanceIs) {
  constexpr std::int32_t last = kCoordinateLimit - 1;
  World world;
  addPart(world, 0, {});
  addPart(world, 1, {});
  Entity entity(world, square(5));
  MapPart(world, 0).insert(entity, {0, 0}, Angle());
  MapPart(world, 1).insert(entity, {0, 100 - last}, Angle());
  EXPECT_FALSE(entity.isAtLimit());
  entity.setVelocity({0, -200});
  world.solve();
  EXPECT_EQ(entity.position(), Point(0, -100));
  EXPECT_TRUE(entity.isAtLimit());
  entity.setVelocity({0, 7});
  world.solve();
  EXPECT_TRUE(entity.isAtLimit()) << "7 subunits from it";
  entity.setVelocity({0, 1});
  world.solve();
  EXPECT_FALSE(entity.isAtLimit());
}

TEST(EntityTest, RefusesValuesOutOfRange) {
  World world;
  Entity entity(world, square(5));
  entity.setVelocity({kVelocityLimit - 1, 0}, Angle(4500));
  const World before = world;
  const std::string velocity =
      "entity 0: the velocity is out of range: its coordinates must be below 2^28 in magnitude";
  EXPECT_EQ(refusal([&] { entity.setVelocity({kVelocityLimit, 0}); }), velocity);
  EXPECT_EQ(refusal([&] { entity.setVelocity({0, INT32_MIN}, Angle(1)); }), velocity);
  EXPECT_EQ(refusal([&] { entity.addVelocity({1, 0}); }), velocity);
  EXPECT_EQ(refusal([&] { entity.addVelocity({0, INT32_MIN}); }), velocity);
  EXPECT_EQ(refusal([&] { entity.addVelocity({INT32_MAX, INT32_MAX}); }), velocity);
  const std::string rotation =
      "entity 0: the rotation is out of range: it must be below 36000 centidegrees in magnitude";
  EXPECT_EQ(refusal([&] { entity.rotate(36000); }), rotation);
  EXPECT_EQ(refusal([&] { entity.rotate(INT32_MIN); }), rotation);
  EXPECT_EQ(world, before);
}

TEST(EntityTest, EraseTakesItOutOfAllPartsAndKeepsIt) {
  World world = twoStrips();
  Entity entity(world, square(100));
  MapPart(world, 1).insert(entity, {950, 0}, Angle());
  ASSERT_EQ(world.view(0).size(), 2u);
  entity.erase();
  EXPECT_FALSE(entity.inserted());
  EXPECT_TRUE(entity.exists());
  EXPECT_TRUE(world.view(0).empty());
  const World before = world;
  entity.erase();
  EXPECT_EQ(world, before) << "it is in no part";
  entity.destroy();
  EXPECT_EQ(refusal([&] { entity.erase(); }), "entity 0 does not exist: it was destroyed");
}

TEST(EntityTest, RefusesHandlesOfEntitiesThatDoNotExist) {
  World world;
  Entity entity(world, square(5));
  Entity lost(world, square(5));
  world.restore({{entity.state()}, {}});
  const World before = world;
  const std::string missing = "entity 1 does not exist: the world has 1 entities, counted from 0";
  EXPECT_EQ(refusal([&] { lost.state(); }), missing);
  EXPECT_EQ(refusal([&] { lost.position(); }), missing);
  EXPECT_EQ(refusal([&] { lost.shape(); }), missing);
  EXPECT_EQ(refusal([&] { lost.setVelocity({1, 1}); }), missing);
  EXPECT_EQ(refusal([&] { lost.addVelocity({1, 1}); }), missing);
  EXPECT_EQ(refusal([&] { lost.rotate(1); }), missing);
  EXPECT_EQ(refusal([&] { lost.erase(); }), missing);
  EXPECT_EQ(refusal([&] { (void)lost.isAtLimit(); }), missing);
  EXPECT_EQ(world, before);
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
}  // namespace platon::entity_test
