#include "shared/game/seen_places.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "platon/game/solid.h"
#include "platon/game/stage.h"
#include "tests/sim/seeded_random.h"

namespace platon::seen_places_test {
namespace {

constexpr std::uint64_t kSeed = 77;
constexpr std::int32_t kFaceSize = 200;

World stageOf(SolidKind kind) {
  const std::vector<std::vector<Segment>> none(static_cast<std::size_t>(PlatonicSolid::of(kind).faces()));
  return buildStage(kind, kFaceSize, none);
}

// The shortest of the distances to the places on the part of `from`.
std::int64_t squaredDistance(const std::vector<Place>& places, const Place& from) {
  std::int64_t nearest = INT64_MAX;
  for (const Place& place : places) {
    if (place.part == from.part) nearest = std::min(nearest, squaredLength(place.position - from.position));
  }
  return nearest;
}

TEST(SeenPlacesTest, APlaceAwayFromTheEdgesIsSeenFromItsFaceAlone) {
  const World world = stageOf(SolidKind::kHexahedron);
  const Place place{2, {3000, -5000}};
  EXPECT_EQ(seenPlaces(world.geometry(), place, 28 * 1024), std::vector<Place>{place});
}

TEST(SeenPlacesTest, APlaceAtAnEdgeIsSeenFromBothFaces) {
  const World world = stageOf(SolidKind::kHexahedron);
  const std::vector<Place> places = seenPlaces(world.geometry(), {0, {100 * 1024 - 500, 1000}}, 28 * 1024);
  ASSERT_EQ(places.size(), 2u);
  EXPECT_EQ(places[1], (Place{1, {-100 * 1024 - 500, 1000}}));
}

// Near a corner of a hexahedron, the third face is reached both ways round the corner.
TEST(SeenPlacesTest, APlaceAtACornerIsSeenOverTwoEdges) {
  const World world = stageOf(SolidKind::kHexahedron);
  const std::int32_t half = 100 * 1024;
  const std::vector<Place> places = seenPlaces(world.geometry(), {0, {half - 500, half - 700}}, 28 * 1024);
  ASSERT_EQ(places.size(), 5u);
  std::multiset<std::uint32_t> parts;
  for (const Place& place : places) parts.insert(place.part);
  EXPECT_EQ(parts, (std::multiset<std::uint32_t>{0, 1, 1, 4, 4}));
}

// Within the distance, a place is as far from another one as the other from it.
TEST(SeenPlacesTest, DistancesAreTheSameBothWays) {
  constexpr std::int32_t kDistance = 40 * 1024;
  for (int kind = 0; kind < kSolidKinds; ++kind) {
    const World world = stageOf(static_cast<SolidKind>(kind));
    sim::SeededRandom random(kSeed);
    int overEdges = 0;
    for (int round = 0; round < 300; ++round) {
      const std::vector<Point> polygon = facePolygon(static_cast<SolidKind>(kind), kFaceSize);
      const auto part = static_cast<std::uint32_t>(random.below(world.geometry().parts.size()));
      const Point corner = polygon[random.below(polygon.size())];
      const Place place{part, {corner.x * 7 / 8, corner.y * 7 / 8}};
      for (const Place& seen : seenPlaces(world.geometry(), place, kDistance)) {
        // A place on the part that sees it, towards the seen one.
        const Point edge = polygon[random.below(polygon.size())];
        const Place other{seen.part, {edge.x * 15 / 16, edge.y * 15 / 16}};
        const auto there = static_cast<double>(squaredDistance(seenPlaces(world.geometry(), place, kDistance), other));
        if (there >= double{1} * kDistance * kDistance) continue;
        overEdges += other.part != place.part;
        const auto back = static_cast<double>(squaredDistance(seenPlaces(world.geometry(), other, kDistance), place));
        EXPECT_NEAR(std::sqrt(there), std::sqrt(back), 3) << "seed " << kSeed << ", solid " << kind;
      }
    }
    EXPECT_GT(overEdges, 20) << kind;
  }
}

}  // namespace
}  // namespace platon::seen_places_test
