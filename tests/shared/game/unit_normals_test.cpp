#include "platon/game/unit_normals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "platon/game/player.h"
#include "tests/sim/seeded_random.h"

namespace platon::unit_normals_test {
namespace {

constexpr std::uint64_t kSeed = 41;
constexpr std::int32_t kUnit = PlayerState::kUnit;

struct Query {
  Point normal;
  Angle turn;
};

std::vector<Query> randomQueries(int count) {
  sim::SeededRandom random(kSeed);
  std::vector<Query> queries;
  while (static_cast<int>(queries.size()) < count) {
    // Lengths of all magnitudes below 2^28.
    const Point normal = random.vector(1 << (1 + random.below(27)));
    if (normal == Point()) continue;
    queries.push_back({normal, Angle(static_cast<std::int32_t>(random.below(Angle::kTurn)))});
  }
  return queries;
}

TEST(UnitNormalsTest, ScalesToTheUnit) {
  UnitNormals normals;
  EXPECT_EQ(normals.of({5, 0}, Angle()), Point(kUnit, 0));
  EXPECT_EQ(normals.of({0, -(1 << 29)}, Angle()), Point(0, -kUnit));
  EXPECT_EQ(normals.of({3, 4}, Angle()), Point(9830, 13107)) << "3/5 and 4/5 of 16384, rounded";
}

TEST(UnitNormalsTest, RotatesCounterClockwise) {
  UnitNormals normals;
  EXPECT_EQ(normals.of({7, 0}, Angle::degrees(90)), Point(0, kUnit));
  EXPECT_EQ(normals.of({0, 7}, Angle::degrees(90)), Point(-kUnit, 0));
  EXPECT_EQ(normals.of({1, 0}, Angle::degrees(45)), Point(11585, 11585)) << "16384 / sqrt(2), rounded";
}

TEST(UnitNormalsTest, IsWithinOneOfTheExactVector) {
  UnitNormals normals;
  for (const auto& [normal, turn] : randomQueries(20000)) {
    const double angle = std::atan2(normal.y, normal.x) + turn.centidegrees() * std::numbers::pi / (Angle::kTurn / 2.0);
    const Point unit = normals.of(normal, turn);
    ASSERT_NEAR(unit.x, kUnit * std::cos(angle), 1) << normal.x << ", " << normal.y << ", seed " << kSeed;
    ASSERT_NEAR(unit.y, kUnit * std::sin(angle), 1) << normal.x << ", " << normal.y << ", seed " << kSeed;
  }
}

// 500 queries share 64 entries, so that most entries are replaced again and again.
TEST(UnitNormalsTest, NoResultDependsOnTheCache) {
  UnitNormals used;
  const auto queries = randomQueries(500);
  for (int round = 0; round < 3; ++round) {
    for (const auto& [normal, turn] : queries) {
      UnitNormals empty;
      ASSERT_EQ(used.of(normal, turn), empty.of(normal, turn)) << normal.x << ", " << normal.y << ", seed " << kSeed;
    }
  }
}

}  // namespace
}  // namespace platon::unit_normals_test
