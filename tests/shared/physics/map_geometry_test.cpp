#include "platon/physics/map_geometry.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <stdexcept>

#include "shared/physics/ideal_geometry.h"
#include "tests/sim/seeded_random.h"

namespace platon::map_geometry_test {
namespace {

constexpr std::uint64_t kSeed = 2718;

MapGeometry part(std::uint32_t id, std::vector<Warp> warps = {}, std::vector<Segment> lines = {}) {
  MapGeometry made;
  made.id = id;
  made.segments = std::move(lines);
  for (const Warp& warp : warps) made.segments.push_back(warp.from);
  made.warps = std::move(warps);
  made.grid = Grid(made.segments);
  return made;
}

constexpr Segment kEast{{100, -50}, {100, 50}};
constexpr Segment kWest{{-100, 50}, {-100, -50}};

constexpr Segment reversed(const Segment& line) { return {line.b, line.a}; }

TEST(MapGeometryTest, OtherSegmentsPrecedeWarps) {
  const MapGeometry made = part(1, {{kEast, 2, reversed(kWest), Angle()}, {kWest, 2, reversed(kEast), Angle()}},
                                {{{0, 0}, {1, 1}}, {{2, 2}, {3, 3}}, {{4, 4}, {4, 4}}});
  ASSERT_EQ(made.segments.size(), 5u);
  for (std::uint32_t line = 0; line < 5; ++line) EXPECT_EQ(made.isWarp(line), line >= 3);
  EXPECT_EQ(made.segmentOfWarp(0), 3u);
  EXPECT_EQ(made.segmentOfWarp(1), 4u);
  EXPECT_EQ(made.warpOfSegment(4), 1u);
  EXPECT_EQ(made.segments[made.segmentOfWarp(1)], kWest);
}

// A warp between segments of length 100 whose frames differ by `turn`.
Warp turnedWarp(Angle turn) {
  const Segment onto{Point(3000, -70) + rotate(kEast.a, turn), Point(3000, -70) + rotate(kEast.b, turn)};
  return {kEast, 2, onto, turn, middle(kEast.a, kEast.b), middle(onto.a, onto.b)};
}

TEST(WarpTest, MapsTheMidpointToItsImage) {
  for (const std::int32_t turn : {0, 3600, 6000, 7200, 9000, 12345}) {
    const Warp warp = turnedWarp(Angle(turn));
    EXPECT_EQ(warp.map(warp.fromMiddle), warp.ontoMiddle) << turn;
    EXPECT_EQ(warp.mapBack(warp.ontoMiddle), warp.fromMiddle) << turn;
  }
}

TEST(WarpTest, RotatesAboutTheMidpoint) {
  const Warp warp = turnedWarp(Angle::degrees(90));
  EXPECT_EQ(warp.map(precise({100, 0})), precise({3000, 30}));
  EXPECT_EQ(warp.map(precise({107, 2})), precise({2998, 37}));
  EXPECT_EQ(warp.mapBack(precise({2998, 37})), precise({107, 2}));
}

TEST(WarpTest, MapBackIsTheInverseUpToRounding) {
  sim::SeededRandom random(kSeed);
  for (int i = 0; i < 20000; ++i) {
    const Warp warp = turnedWarp(Angle(static_cast<std::int32_t>(random.below(Angle::kTurn))));
    const PrecisePoint point = precise(random.vector((2 << (i % 10)) - 1)) + PrecisePoint{i % 65536, -i % 65536};
    const PrecisePoint error = warp.mapBack(warp.map(point)) - point;
    const std::int64_t limit = 2 + (maxNorm(point - warp.fromMiddle) >> 27);
    ASSERT_LE(std::abs(error.x), limit) << "seed " << kSeed << ", round " << i;
    ASSERT_LE(std::abs(error.y), limit) << "seed " << kSeed << ", round " << i;
  }
}

TEST(GeometryTest, EqualityComparesTheContent) {
  const Geometry none;
  const auto one = withPart(none, part(1, {turnedWarp(Angle(3600))}, {{{0, 0}, {1, 1}}}));
  EXPECT_EQ(*one, *withPart(none, part(1, {turnedWarp(Angle(3600))}, {{{0, 0}, {1, 1}}})));
  EXPECT_FALSE(*one == none);
  EXPECT_FALSE(*one == *withPart(none, part(2, {turnedWarp(Angle(3600))}, {{{0, 0}, {1, 1}}})));
  EXPECT_FALSE(*one == *withPart(none, part(1, {turnedWarp(Angle(3601))}, {{{0, 0}, {1, 1}}})));
  EXPECT_FALSE(*one == *withPart(none, part(1, {turnedWarp(Angle(3600))}, {{{0, 0}, {1, 2}}})));
  const auto two = withPart(*one, part(2));
  EXPECT_FALSE(*one == *two);
  EXPECT_EQ(*two, *withPart(*one, part(2))) << "part 1 is shared, part 2 is equal";
}

TEST(GeometryTest, FindsPartsById) {
  auto geometry = std::make_shared<const Geometry>();
  for (const std::uint32_t id : {7u, 0u, 4000000000u, 12345u}) geometry = withPart(*geometry, part(id));
  ASSERT_EQ(geometry->parts.size(), 4u);
  for (const std::uint32_t id : {0u, 7u, 12345u, 4000000000u}) {
    ASSERT_NE(geometry->find(id), nullptr);
    EXPECT_EQ(geometry->find(id)->id, id);
  }
  EXPECT_EQ(geometry->find(1), nullptr);
  EXPECT_EQ(geometry->find(4294967295u), nullptr);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_LT(geometry->parts[i - 1]->id, geometry->parts[i]->id);
}

TEST(GeometryTest, WithPartDoesNotChangeTheOriginal) {
  const auto before = withPart(Geometry(), part(1));
  const auto after = withPart(*before, part(2));
  EXPECT_EQ(before->find(2), nullptr);
  EXPECT_EQ(after->find(1), before->find(1)) << "parts are shared";
}

TEST(GeometryTest, TagsArePartOfAPart) {
  MapGeometry tagged = part(2);
  tagged.tags = {0, 3};
  const auto plain = withPart(Geometry(), part(1));
  EXPECT_FALSE(*withPart(*plain, tagged) == *withPart(*plain, part(2)));
}

TEST(GeometryTest, IdsAreUnique) {
  const auto geometry = withPart(Geometry(), part(5));
  try {
    withPart(*geometry, part(5));
    FAIL();
  } catch (const std::invalid_argument& reason) {
    EXPECT_STREQ(reason.what(),
                 "map part 5 is already initialised: call initialize() once, and give another part another id");
  }
}

TEST(GeometryTest, ReverseWarpUsesTheReversedSegment) {
  const Warp there{kEast, 2, reversed(kWest), Angle()};
  const Warp other{{{0, 0}, {9, 0}}, 1, {{0, 9}, {9, 9}}, Angle()};
  const Warp back{kWest, 1, reversed(kEast), Angle()};
  auto geometry = withPart(Geometry(), part(1, {there}));
  EXPECT_EQ(geometry->reverseWarp(1, there), std::nullopt) << "no target yet";
  geometry = withPart(*geometry, part(2, {other, back}));
  EXPECT_EQ(geometry->reverseWarp(1, there), 1);
  EXPECT_EQ(geometry->reverseWarp(2, back), 0);
  EXPECT_EQ(geometry->reverseWarp(3, there), std::nullopt) << "it leads back to another part";
  EXPECT_EQ(geometry->reverseWarp(2, other), std::nullopt);
}

TEST(GeometryTest, ReverseWarpMustStartAtTheSameSegment) {
  const Warp there{kEast, 2, reversed(kWest), Angle()};
  Warp shifted{kWest, 1, reversed(kEast), Angle()};
  shifted.from.a.y += 1;
  const auto geometry = withPart(*withPart(Geometry(), part(1, {there})), part(2, {shifted}));
  EXPECT_EQ(geometry->reverseWarp(1, there), std::nullopt);
}

TEST(GeometryTest, ReverseWarpMustLeadToTheSameSegment) {
  const Warp there{kEast, 2, reversed(kWest), Angle()};
  Warp shifted{kWest, 1, reversed(kEast), Angle()};
  shifted.onto.a.y += 1;
  const auto geometry = withPart(*withPart(Geometry(), part(1, {there})), part(2, {shifted}));
  EXPECT_EQ(geometry->reverseWarp(1, there), std::nullopt);
}

TEST(GeometryTest, FindsReverseWarpsWithinOnePart) {
  const Warp right{kEast, 1, reversed(kWest), Angle()};
  const Warp left{kWest, 1, reversed(kEast), Angle()};
  const auto geometry = withPart(Geometry(), part(1, {right, left}));
  EXPECT_EQ(geometry->reverseWarp(1, right), 1);
  EXPECT_EQ(geometry->reverseWarp(1, left), 0);
}

}  // namespace
}  // namespace platon::map_geometry_test
