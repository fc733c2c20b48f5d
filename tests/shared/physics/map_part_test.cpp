#include "platon/physics/map_part.h"

#include <gtest/gtest.h>

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "platon/exact/integer.h"
#include "platon/physics/entity.h"
#include "platon/physics/world.h"
#include "tests/shared/physics/maps.h"
#include "tests/shared/physics/refusal.h"
#include "tests/shared/physics/shapes.h"

namespace platon::map_part_test {
namespace {

constexpr std::int32_t kMax = kCoordinateLimit - 1;

TEST(MapPartTest, SegmentsMayCrossRepeatAndBePoints) {
  World world;
  MapPart face(world, 1);
  for (int i = 0; i < 3; ++i) face.line({-10, -10}, {10, 10});
  face.line({-10, 10}, {10, -10});
  face.line({kMax, -kMax}, {kMax, -kMax});
  face.initialize();
  EXPECT_EQ(world.geometry().find(1)->segments.size(), 5u);
}

TEST(MapPartTest, LineReturnsTheIndexOfTheSegment) {
  World world;
  MapPart face(world, 1);
  EXPECT_EQ(face.line({0, 0}, {10, 0}), 0u);
  face.warp({0, 0}, {100, 0}, 2, {0, 0}, {100, 0});
  EXPECT_EQ(face.line({0, 5}, {10, 5}, 6), 1u) << "warps come after all segments";
  EXPECT_NE(refusal([&] { face.line({0, 0}, {kMax + 1, 5}, 9); }), "");
  EXPECT_EQ(face.line({0, 7}, {10, 7}), 2u) << "what was refused has no index";
  face.initialize();
  const MapGeometry& part = *world.geometry().find(1);
  EXPECT_EQ(part.segments[1], (Segment{{0, 5}, {10, 5}}));
  EXPECT_EQ(part.segments[2], (Segment{{0, 7}, {10, 7}}));
  EXPECT_EQ(part.tags, (std::vector<std::uint32_t>{0, 6})) << "no more than needed";
  EXPECT_EQ(part.tagOf(1), 6u);
  for (const std::uint32_t other : {0u, 2u, 3u, 100u}) EXPECT_EQ(part.tagOf(other), 0u) << other;
}

TEST(MapPartTest, RejectsCoordinatesOutOfRange) {
  World world;
  MapPart face(world, 7);
  const auto outside = [](const char* point) {
    return std::string("map part 7: the point ") + point +
           " is out of range: coordinates must be below 2^29 in magnitude";
  };
  EXPECT_EQ(refusal([&] { face.line({0, 0}, {kMax + 1, 5}); }), outside("(536870912, 5)"));
  EXPECT_EQ(refusal([&] { face.line({0, -kMax - 1}, {0, 5}); }), outside("(0, -536870912)"));
  EXPECT_EQ(refusal([&] { face.warp({0, 0}, {INT32_MAX, 0}, 1, {0, 0}, {1, 0}); }), outside("(2147483647, 0)"));
  EXPECT_EQ(refusal([&] { face.warp({0, 0}, {1, 0}, 1, {0, 0}, {0, INT32_MIN}); }), outside("(0, -2147483648)"));
  face.initialize();
  EXPECT_TRUE(world.geometry().find(7)->segments.empty()) << "what was refused is not in it";
}

TEST(MapPartTest, RejectsWarpsThatAreNotIsometries) {
  World world;
  MapPart face(world, 7);
  face.warp({0, 0}, {100, 0}, 2, {0, 0}, {100, 0});
  EXPECT_EQ(refusal([&] {
              face.warp({5, 5}, {5, 5}, 2, {0, 0}, {1, 0});
            }),
            "map part 7, warp 1: the two ends of the segment are equal");
  EXPECT_EQ(refusal([&] {
              face.warp({0, 0}, {1, 0}, 2, {5, 5}, {5, 5});
            }),
            "map part 7, warp 1: the two ends of the segment are equal");
  const std::string differs =
      "map part 7, warp 1: the segment and its image differ in length, or the rotation between them "
      "is not a whole number of centidegrees";
  EXPECT_EQ(refusal([&] { face.warp({0, 0}, {100, 0}, 2, {0, 0}, {103, 0}); }), differs);
  EXPECT_EQ(refusal([&] { face.warp({0, 0}, {1000000, 0}, 2, {0, 0}, {1000000, 50}); }), differs);
  EXPECT_EQ(refusal([&] {
              face.warp({0, 0}, {100, 0}, 2, {0, 0}, {102, 0});
            }),
            "")
      << "the rounding of the ends is tolerated";
}

TEST(MapPartTest, ComputesTheTurnOfWarps) {
  World world;
  MapPart face(world, 7);
  face.line({0, 0}, {1, 1});
  face.warp({0, 0}, {100000, 0}, 2, {0, 0}, {0, 100000});
  face.warp({0, 0}, {100000, 0}, 3, {50000, 86603}, {0, 0});
  face.initialize();
  const auto& warps = world.geometry().find(7)->warps;
  ASSERT_EQ(warps.size(), 2u);
  EXPECT_EQ(warps[0].turn, Angle::degrees(90));
  EXPECT_EQ(warps[1].turn, Angle::degrees(240));
  EXPECT_EQ(warps[1].target, 3u);
  EXPECT_TRUE(world.geometry().find(7)->isWarp(1));
}

TEST(MapPartTest, RejectsDuplicateIds) {
  World world;
  MapPart(world, 3).initialize();
  MapPart again(world, 3);
  EXPECT_EQ(refusal([&] { again.initialize(); }),
            "map part 3 is already initialised: call initialize() once, and give another part another id");
}

// The text spoke of ids only.
TEST(MapPartTest, ASecondInitializeSaysThatOneIsEnough) {
  World world;
  MapPart face(world, 3);
  face.line({0, 0}, {10, 0});
  face.initialize();
  const World before = world;
  EXPECT_EQ(refusal([&] { face.initialize(); }),
            "map part 3 is already initialised: call initialize() once, and give another part another id");
  EXPECT_EQ(world, before);
}

// Such a warp blocked, and nobody was told.
TEST(MapPartTest, AWarpThatCannotBePassedIsAFaultOfTheMap) {
  World world;
  EXPECT_EQ(world.mapFault(), std::nullopt);
  addLeftStrip(world);
  const std::string blocks = "map part 1, warp 0: it blocks like a wall, since map part 2 ";
  EXPECT_EQ(world.mapFault(), blocks + "is not initialised");
  World oneWay = world;
  addPart(oneWay, 2, {});
  EXPECT_EQ(oneWay.mapFault(), blocks + "has no reverse warp: add one there, with the ends of both segments exchanged");
  addRightStrip(world);
  EXPECT_EQ(world.mapFault(), std::nullopt);
  MapPart last(world, 9);
  last.warp({1000, -5000}, {1000, 5000}, 1, {-1000, -5000}, {-1000, 5000});
  last.initialize();
  EXPECT_EQ(world.mapFault(),
            "map part 9, warp 0: it blocks like a wall, since map part 1 has no reverse warp: add one "
            "there, with the ends of both segments exchanged");
}

TEST(MapPartTest, RejectsSegmentsAndWarpsAfterInitialize) {
  World world;
  MapPart face(world, 3);
  face.line({0, 0}, {10, 0});
  face.initialize();
  const World before = world;
  const std::string late = "map part 3 is already initialised: add its segments and warps before initialize()";
  EXPECT_EQ(refusal([&] { face.line({0, 0}, {1, 1}); }), late);
  EXPECT_EQ(refusal([&] { face.warp({0, 0}, {100, 0}, 2, {0, 0}, {100, 0}); }), late);
  MapPart another(world, 3);
  EXPECT_EQ(refusal([&] { another.line({0, 0}, {1, 1}); }), late);
  EXPECT_EQ(world, before);
}

// The text of the std::logic_error of a step.
std::string refusedStep(World& world) {
  try {
    world.solve();
  } catch (const std::invalid_argument&) {
    return "another error";
  } catch (const std::logic_error& reason) {
    return reason.what();
  }
  return "";
}

// Nothing met the segments of a part whose initialize() was forgotten, and nobody was told.
TEST(MapPartTest, AStepIsRefusedWhileAPartIsNotInitialised) {
  World world;
  MapPart empty(world, 2);
  EXPECT_EQ(refusedStep(world), "") << "a handle alone has nothing to initialise";
  MapPart face(world, 3);
  face.line({0, 0}, {10, 0});
  {
    MapPart lost(world, 4);
    lost.warp({0, 0}, {100, 0}, 2, {0, 0}, {100, 0});
  }
  const World before = world;
  const auto open = [](int part) {
    return "map part " + std::to_string(part) +
           " has segments or warps but was not initialised, so nothing meets them: call MapPart::initialize() before "
           "solve()";
  };
  EXPECT_EQ(refusedStep(world), open(3));
  EXPECT_EQ(world, before);
  MapPart copy = face;
  copy.line({0, 5}, {10, 5});
  copy.initialize();
  EXPECT_EQ(refusedStep(world), open(4)) << "the handle is gone";
  World moved = std::move(world);
  EXPECT_EQ(refusedStep(moved), open(4));
  World other = moved;
  EXPECT_EQ(refusedStep(other), "") << "a copy has no handles";
  MapPart(moved, 4).initialize();
  EXPECT_EQ(refusedStep(moved), "");
  MapPart five(other, 5);
  five.line({0, 0}, {10, 0});
  MapPart(moved, 5).initialize();
  other = moved;
  EXPECT_EQ(refusedStep(other), "") << "the world has a part 5 now";
}

TEST(MapPartTest, APartWhoseInitializeWasRefusedDoesNotForbidAStep) {
  World world;
  MapPart clockwise(world, 1);
  clockwise.warp({0, 0}, {0, 1000}, 2, {0, 0}, {0, 1000});
  clockwise.warp({0, 1000}, {1000, 1000}, 2, {0, 1000}, {1000, 1000});
  EXPECT_NE(refusal([&] { clockwise.initialize(); }), "");
  EXPECT_EQ(refusedStep(world), "") << "it was told already";
  MapPart late(world, 1);
  EXPECT_NE(refusal([&] { late.line({0, 0}, {1 << 29, 0}); }), "");
  EXPECT_EQ(refusedStep(world), "") << "it has got nothing";
}

// Adds the edges of a polygon as warps to part 2.
void addEdges(MapPart& part, const std::vector<Point>& polygon) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point a = polygon[i];
    const Point b = polygon[(i + 1) % polygon.size()];
    part.warp(a, b, 2, b, a);
  }
}

TEST(MapPartTest, RejectsWarpsThatDoNotBoundAConvexArea) {
  World world;
  MapPart angle(world, 1);
  addEdges(angle, {{0, 0}, {2000, 0}, {2000, 1000}, {1000, 1000}, {1000, 2000}, {0, 2000}});
  const World before = world;
  EXPECT_EQ(refusal([&] { angle.initialize(); }),
            "map part 1: warp 3 is on the right of warp 2: the warps of a part must bound a convex area on their left; "
            "divide the part");
  EXPECT_EQ(world, before);
  MapPart clockwise(world, 1);
  addEdges(clockwise, {{0, 0}, {0, 1000}, {1000, 1000}, {1000, 0}});
  EXPECT_NE(refusal([&] { clockwise.initialize(); }), "");
  const std::vector<Point> pentagon = regular(5, 1000).vertices();
  MapPart star(world, 1);
  addEdges(star, {pentagon[0], pentagon[2], pentagon[4], pentagon[1], pentagon[3]});
  EXPECT_NE(refusal([&] { star.initialize(); }), "") << "it turns left at every corner";
  MapPart notch(world, 1);  // the inner corner alone; walls could be around the rest
  notch.warp({2000, 1000}, {1000, 1000}, 2, {0, 0}, {-1000, 0});
  notch.warp({1000, 1000}, {1000, 2000}, 2, {0, 0}, {0, 1000});
  EXPECT_NE(refusal([&] { notch.initialize(); }), "");
}

TEST(MapPartTest, AcceptsWarpsThatBoundAConvexArea) {
  World world;
  std::uint32_t id = 10;
  for (const int count : {3, 4, 5, 6, 16}) {
    for (const std::int32_t radius : {1000, 1 << 28}) {
      MapPart face(world, id++);
      addEdges(face, regular(count, radius).vertices());
      EXPECT_EQ(refusal([&] { face.initialize(); }), "") << count << " edges, radius " << radius;
    }
  }
  for (const std::int32_t y : {1999, 2000}) {  // an edge of two warps whose common end is rounded
    MapPart divided(world, id++);
    addEdges(divided, {{0, 0}, {5000, y}, {10001, 4000}, {0, 9000}});
    EXPECT_EQ(refusal([&] { divided.initialize(); }), "") << y;
  }
  MapPart twoSides(world, 2);  // the same segment from both sides
  twoSides.warp({0, 0}, {100, 0}, 3, {0, 0}, {100, 0});
  twoSides.warp({100, 0}, {0, 0}, 4, {0, 0}, {100, 0});
  EXPECT_EQ(refusal([&] { twoSides.initialize(); }), "");
  MapPart longest(world, 3);
  addEdges(longest, {{-kMax, -kMax}, {kMax, -kMax}, {kMax, kMax}, {-kMax, kMax}});
  EXPECT_EQ(refusal([&] { longest.initialize(); }), "");
}

class MapPartInsertTest : public testing::Test {
 protected:
  MapPartInsertTest() : part(world, 4), entity(world, square(10)) {
    part.line({50, -100}, {50, 100});
    part.initialize();
  }

  World world;
  MapPart part;
  Entity entity;
};

TEST_F(MapPartInsertTest, PlacesTheEntity) {
  EXPECT_FALSE(entity.inserted());
  part.insert(entity, Point(7, -3), Angle::degrees(90));
  EXPECT_TRUE(entity.inserted());
  EXPECT_EQ(entity.position(), Point(7, -3));
  EXPECT_EQ(entity.rotation(), Angle::degrees(90));
  EXPECT_EQ(entity.part(), 4u);
}

TEST_F(MapPartInsertTest, AcceptsTouchingPositions) {
  part.insert(entity, Point(40, 0), Angle());
  EXPECT_EQ(entity.position(), Point(40, 0));
}

TEST_F(MapPartInsertTest, RejectsOverlappingPositions) {
  const WorldState before = world.save();
  EXPECT_EQ(refusal([&] { part.insert(entity, Point(41, 0), Angle()); }),
            "entity 0 in map part 4: the shape overlaps a blocking segment");
  EXPECT_EQ(refusal([&] { part.insert(entity, Point(38, 0), Angle::degrees(45)); }),
            "entity 0 in map part 4: the shape overlaps a blocking segment");
  EXPECT_EQ(world.save(), before);
  EXPECT_FALSE(entity.inserted());
}

TEST_F(MapPartInsertTest, RejectsPartsThatAreNotInitialised) {
  MapPart missing(world, 9);
  EXPECT_EQ(refusal([&] { missing.insert(entity, Point(0, 0), Angle()); }),
            "entity 0 in map part 9: the part is not initialised");
}

TEST_F(MapPartInsertTest, RejectsASecondInsertion) {
  part.insert(entity, Point(0, 0), Angle());
  const WorldState before = world.save();
  EXPECT_EQ(refusal([&] { part.insert(entity, Point(9, 9), Angle()); }),
            "entity 0 in map part 4: the entity is already in this part: erase it first");
  EXPECT_EQ(world.save(), before);
  part.erase(entity);
  EXPECT_FALSE(entity.inserted());
  part.insert(entity, Point(9, 9), Angle());
  EXPECT_EQ(entity.position(), Point(9, 9));
}

TEST_F(MapPartInsertTest, RejectsPositionsOutOfRange) {
  EXPECT_EQ(refusal([&] { part.insert(entity, Point(kMax + 1, 0), Angle()); }),
            "map part 4: the point (536870912, 0) is out of range: coordinates must be below 2^29 in magnitude");
  EXPECT_FALSE(entity.inserted());
}

TEST_F(MapPartInsertTest, RejectsEntitiesOfAnotherWorld) {
  World other;
  Entity first(other, square(10));
  Entity second(other, square(10));  // this world has no entity with its index
  part.insert(entity, Point(0, 0), Angle());
  const World before = world;
  const World otherBefore = other;
  const std::string foreign = " belongs to another world: use an entity of the world of this part";
  EXPECT_EQ(refusal([&] { part.insert(first, Point(9, 9), Angle()); }), "map part 4: entity 0" + foreign);
  EXPECT_EQ(refusal([&] { part.insert(second, Point(9, 9), Angle()); }), "map part 4: entity 1" + foreign);
  EXPECT_EQ(refusal([&] { part.erase(first); }), "map part 4: entity 0" + foreign);
  EXPECT_EQ(refusal([&] { part.erase(second); }), "map part 4: entity 1" + foreign);
  EXPECT_EQ(world, before);
  EXPECT_EQ(other, otherBefore);
}

TEST_F(MapPartInsertTest, RejectsEntitiesThatDoNotExist) {
  Entity missing(world, 1);
  const World before = world;
  const std::string refused = "entity 1 does not exist: the world has 1 entities, counted from 0";
  EXPECT_EQ(refusal([&] { part.insert(missing, Point(0, 0), Angle()); }), refused);
  EXPECT_EQ(refusal([&] { part.erase(missing); }), refused);
  EXPECT_EQ(world, before);
}

TEST_F(MapPartInsertTest, RejectsAnglesAtWhichTheShapeDegenerates) {
  Entity sliver(world, Convex(std::vector<Point>{{0, 0}, {3, 1}, {2, 1}}));
  EXPECT_EQ(refusal([&] { part.insert(sliver, Point(0, 0), Angle::degrees(20)); }),
            "entity 1 in map part 4: the shape is degenerate when rotated by this angle and rounded");
  EXPECT_FALSE(sliver.inserted());
}

TEST_F(MapPartInsertTest, ErasingFromAnotherPartChangesNothing) {
  MapPart other(world, 5);
  other.initialize();
  other.erase(entity);
  part.insert(entity, Point(0, 0), Angle());
  const WorldState before = world.save();
  other.erase(entity);
  MapPart(world, 99).erase(entity);
  EXPECT_EQ(world.save(), before);
}

}  // namespace
}  // namespace platon::map_part_test
