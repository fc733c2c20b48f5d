#include "platon/physics/map_part.h"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>
#include <string>

#include "platon/exact/integer.h"
#include "platon/physics/entity.h"
#include "platon/physics/world.h"
#include "tests/shared/physics/shapes.h"

namespace platon {
namespace {

constexpr std::int32_t kMax = kCoordinateLimit - 1;

std::string refusal(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::invalid_argument& reason) {
    return reason.what();
  }
  return "";
}

TEST(MapPartTest, RunsTheExampleOfTheReport) {
  World world;
  MapPart face(world, 12345);
  face.line(Point(0, 0), Point(-50, 20));
  face.line(Point(-50, 20), Point(100, 80));
  face.initialize();
  const MapGeometry* part = world.geometry().find(12345);
  ASSERT_NE(part, nullptr);
  EXPECT_EQ(part->segments, (std::vector<Segment>{{{0, 0}, {-50, 20}}, {{-50, 20}, {100, 80}}}));
  EXPECT_TRUE(part->warps.empty());
  EXPECT_EQ(face.id(), 12345u);
}

TEST(MapPartTest, SegmentsMayCrossRepeatAndBePoints) {
  World world;
  MapPart face(world, 1);
  for (int i = 0; i < 3; ++i) face.line({-10, -10}, {10, 10});
  face.line({-10, 10}, {10, -10});
  face.line({kMax, -kMax}, {kMax, -kMax});
  face.initialize();
  EXPECT_EQ(world.geometry().find(1)->segments.size(), 5u);
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
  EXPECT_EQ(refusal([&] { again.initialize(); }), "map part 3 is already initialised: ids must be unique");
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
}  // namespace platon
