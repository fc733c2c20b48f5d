#include "shared/game/crowding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "platon/exact/integer.h"
#include "platon/game/level.h"
#include "platon/game/stage.h"
#include "tests/sim/seeded_random.h"
#include "tests/support/run/repetitions.h"

namespace platon::crowding_test {
namespace {

constexpr std::uint64_t kSeed = 512;
constexpr std::int32_t kUnit = kSubunitsPerUnit;
constexpr std::int32_t kSize = 480;

using Segments = std::vector<std::vector<Segment>>;

Segments onFaces(SolidKind kind) { return Segments(static_cast<std::size_t>(PlatonicSolid::of(kind).faces())); }

std::vector<CrowdedPlace> placesOf(SolidKind kind, const Segments& segments, std::int32_t size = kSize) {
  const World faces = buildStage(kind, size, onFaces(kind));
  return Crowding(faces.geometry(), segments).find();
}

Segment pointAt(std::int32_t x, std::int32_t y) { return {{x, y}, {x, y}}; }

// A place near which there are exactly as many segments as are allowed, and one more.
TEST(Crowding, OneSegmentTooManyIsFound) {
  Segments segments = onFaces(SolidKind::kHexahedron);
  segments[2].assign(kMaxSegmentsInReach, pointAt(5 * kUnit, 7 * kUnit));
  EXPECT_TRUE(placesOf(SolidKind::kHexahedron, segments).empty());
  segments[2].push_back(pointAt(0, 0));
  const auto places = placesOf(SolidKind::kHexahedron, segments);
  ASSERT_EQ(places.size(), 1u);
  EXPECT_EQ(places[0].face, 2u);
  EXPECT_EQ(places[0].segmentFace, 2u);
  EXPECT_EQ(places[0].segment, kMaxSegmentsInReach) << "the last one is the one too many";
  const Box square = Box{places[0].centre, places[0].centre}.grown(Crowding::kPlace / 2 + Crowding::kReach);
  EXPECT_TRUE(touches(segments[2][0], square));
  EXPECT_TRUE(touches(segments[2].back(), square));
}

TEST(Crowding, SegmentsOutOfReachOfEachOtherAreNotCounted) {
  constexpr std::int32_t kFar = Crowding::kPlace + 2 * Crowding::kReach + 1;
  for (const Point apart : {Point(kFar, 0), Point(0, kFar), Point(-kFar, kFar)}) {
    Segments segments = onFaces(SolidKind::kHexahedron);
    for (std::size_t i = 0; i < kMaxSegmentsInReach; ++i) {
      segments[0].push_back(pointAt(0, 0));
      segments[0].push_back({apart, apart + Point(7, 0)});
    }
    EXPECT_TRUE(placesOf(SolidKind::kHexahedron, segments).empty()) << apart.x << ", " << apart.y;
  }
}

// The bounding boxes of all lines overlap, but each place has only 500 of them near.
TEST(Crowding, ALongLineCountsOnlyWhereItIs) {
  Segments segments = onFaces(SolidKind::kHexahedron);
  constexpr std::int32_t kHalf = 160 * kUnit;
  for (std::int32_t i = 0; i < 1000; ++i) {
    const Point offset = perpendicular({(i - 500) * 163, (i - 500) * 163});
    segments[0].push_back({Point(-kHalf / 2, -kHalf / 2) + offset, Point(kHalf / 2, kHalf / 2) + offset});
  }
  EXPECT_TRUE(placesOf(SolidKind::kHexahedron, segments).empty());
  segments[0].assign(2 * kMaxSegmentsInReach, segments[0][500]);
  EXPECT_EQ(placesOf(SolidKind::kHexahedron, segments).size(), 1u);
}

// Tiles of 64 units begin at -240. The place between y = 16 and 24 reaches points just below y = 60, and, to y = -20,
// lines that come into its tile only far to the right.
TEST(Crowding, SlantedLinesBelowATileCount) {
  Segments segments = onFaces(SolidKind::kHexahedron);
  constexpr std::int32_t kLeft = -200 * kUnit;
  for (std::size_t i = 0; i < kMaxSegmentsInReach / 2 + 1; ++i) {
    segments[0].push_back(pointAt(kLeft, 60 * kUnit - 1));
    segments[0].push_back({{kLeft, -19 * kUnit}, {100 * kUnit, 20 * kUnit}});
  }
  EXPECT_EQ(placesOf(SolidKind::kHexahedron, segments).size(), 1u);
}

// Half of the segments on each side of an edge, as near to it as a player reaches.
TEST(Crowding, SegmentsBehindAnEdgeCount) {
  for (int kind = 0; kind < kSolidKinds; ++kind) {
    SCOPED_TRACE(kind);
    const auto solid = static_cast<SolidKind>(kind);
    const World faces = buildStage(solid, kSize, onFaces(solid));
    const Warp& warp = faces.geometry().find(0)->warps[0];
    const auto inwards = [](const Segment& edge, std::int32_t distance) {
      const Point along = edge.b - edge.a;
      const Point middle = edge.a + Point(along.x / 2, along.y / 2);
      const double length = std::sqrt(static_cast<double>(squaredLength(along)));
      return middle + Point(static_cast<std::int32_t>(-along.y / length * distance),
                            static_cast<std::int32_t>(along.x / length * distance));
    };
    for (const std::int32_t distance : {5 * kUnit, 15 * kUnit, 100 * kUnit}) {
      Segments segments = onFaces(solid);
      const Point here = inwards(warp.from, distance);
      const Point there = inwards({warp.onto.b, warp.onto.a}, distance);
      segments[0].assign(kMaxSegmentsInReach / 2, {here, here});
      segments[warp.target].assign(kMaxSegmentsInReach / 2 + 1, {there, there});
      EXPECT_EQ(placesOf(solid, segments).empty(), distance == 100 * kUnit) << distance;
    }
  }
}

// All faces at a corner have a part of the segments.
TEST(Crowding, SegmentsRoundACornerCount) {
  for (int kind = 0; kind < kSolidKinds; ++kind) {
    SCOPED_TRACE(kind);
    const auto solid = static_cast<SolidKind>(kind);
    Segments segments = onFaces(solid);
    const std::vector<Point> polygon = facePolygon(solid, kSize);
    const PlatonicSolid& topology = PlatonicSolid::of(solid);
    int faces = 0;
    for (int face = 0; face < topology.faces(); ++face) {
      for (int corner = 0; corner < topology.edgesPerFace(); ++corner) {
        if (topology.vertex(face, corner) != topology.vertex(0, 0)) continue;
        const Point at = polygon[static_cast<std::size_t>(corner)];
        const Point inside(at.x - at.x / 30, at.y - at.y / 30);  // a few units from the corner
        segments[static_cast<std::size_t>(face)].assign(200, {inside, inside});
        ++faces;
      }
    }
    ASSERT_GE(faces, 3);
    EXPECT_FALSE(placesOf(solid, segments).empty());
  }
}

// The count of every place, without tiles.
TEST(Crowding, FindsWhatCountingEveryPlaceFinds) {
  sim::SeededRandom random(kSeed);
  const int kRuns = repetitions(40);
  int crowded = 0;
  for (int run = 0; run < kRuns; ++run) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", run " + std::to_string(run));
    Segments segments = onFaces(SolidKind::kHexahedron);
    const std::int32_t spread = (60 + 40 * run / kRuns) * kUnit;
    for (int i = 0; i < 1200; ++i) {
      const Point at = random.vector(spread);
      segments[0].push_back({at, at + random.vector(i % 4 == 0 ? 60 * kUnit : 2 * kUnit)});
    }
    const Point origin(-kSize / 2 * kUnit, -kSize / 2 * kUnit);
    bool expected = false;
    for (std::int32_t y = 0; y < kSize * kUnit && !expected; y += Crowding::kPlace) {
      for (std::int32_t x = 0; x < kSize * kUnit && !expected; x += Crowding::kPlace) {
        const Point low = origin + Point(x, y);
        const Box square = Box{low, low + Point(Crowding::kPlace, Crowding::kPlace)}.grown(Crowding::kReach);
        const auto count = std::count_if(segments[0].begin(), segments[0].end(),
                                         [&](const Segment& segment) { return touches(segment, square); });
        expected = count > static_cast<std::ptrdiff_t>(kMaxSegmentsInReach);
      }
    }
    EXPECT_EQ(!placesOf(SolidKind::kHexahedron, segments).empty(), expected);
    crowded += expected ? 1 : 0;
  }
  EXPECT_GT(crowded, kRuns / 8);
  EXPECT_LT(crowded, kRuns * 7 / 8);
}

// The count of every place is not above the bound, and that of the square of eight places not below it.
TEST(Crowding, TheBoundIsBetweenTheCountsOfSmallAndOfLargeSquares) {
  sim::SeededRandom random(kSeed);
  const auto mostIn = [](const std::vector<Segment>& segments, std::int32_t side) {
    std::size_t most = 0;
    for (std::int32_t y = -kSize / 2 * kUnit; y < kSize / 2 * kUnit; y += side) {
      for (std::int32_t x = -kSize / 2 * kUnit; x < kSize / 2 * kUnit; x += side) {
        const Box square = Box{{x, y}, {x + side, y + side}}.grown(Crowding::kReach);
        most = std::max(
            most, static_cast<std::size_t>(std::count_if(segments.begin(), segments.end(), [&](const Segment& segment) {
              return touches(segment, square);
            })));
      }
    }
    return most;
  };
  for (int run = 0; run < 20; ++run) {
    SCOPED_TRACE(run);
    Segments segments = onFaces(SolidKind::kHexahedron);
    for (int i = 0; i < 20 + 10 * run; ++i) {
      const Point at = random.vector(150 * kUnit);
      segments[0].push_back({at, at + random.vector(run % 2 == 0 ? 60 * kUnit : 2 * kUnit)});
    }
    const World faces = buildStage(SolidKind::kHexahedron, kSize, onFaces(SolidKind::kHexahedron));
    const std::size_t most = Crowding(faces.geometry(), segments).most();
    EXPECT_GE(most, mostIn(segments[0], Crowding::kPlace));
    EXPECT_LE(most, segments[0].size());
    EXPECT_LE(most, mostIn(segments[0], 8 * Crowding::kPlace) + 8);  // beside the range of a row, also its ends count
  }
}

TEST(Crowding, TheBoundCountsSegmentsBehindTheEdges) {
  Segments segments = onFaces(SolidKind::kHexahedron);
  const World faces = buildStage(SolidKind::kHexahedron, kSize, segments);
  const auto most = [&] { return Crowding(faces.geometry(), segments).most(); };
  EXPECT_EQ(most(), 0U);
  const Warp& warp = faces.geometry().find(0)->warps[0];
  const Point middle(warp.from.a.x / 2 + warp.from.b.x / 2, warp.from.a.y / 2 + warp.from.b.y / 2);
  const Point near(middle.x - middle.x / 30, middle.y - middle.y / 30);
  const Point beyond = rounded(warp.map(precise({middle.x + middle.x / 30, middle.y + middle.y / 30})));
  segments[0].assign(7, {near, near});
  EXPECT_EQ(most(), 7U);
  segments[warp.target].assign(5, {beyond, beyond});
  EXPECT_EQ(most(), 12U);
  segments[0].assign(5000, {near, near});
  EXPECT_EQ(most(), kMaxSegmentsInReach);
}

}  // namespace
}  // namespace platon::crowding_test
