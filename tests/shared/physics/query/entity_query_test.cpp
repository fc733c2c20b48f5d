#include "platon/physics/entity_query.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "platon/physics/query.h"
#include "tests/exactness/oracle/exact_geometry.h"
#include "tests/shared/physics/maps.h"
#include "tests/shared/physics/refusal.h"
#include "tests/shared/physics/shapes.h"

namespace platon::entity_query_test {
namespace {

constexpr std::uint64_t kSeed = 99;

// Where the two parts meet, in the frame of part 1 or 2.
Point nearTheEdge(sim::SeededRandom& random, std::uint32_t part) {
  return Point(part == 1 ? 1000 : -1000, 0) + random.vector(400);
}

World crowdedWorld(sim::SeededRandom& random) {
  World world = twoStrips();
  for (std::uint32_t i = 0; i < 30; ++i) {
    const Convex shape = randomConvex(random, 60, i % 3 == 0 ? Point(30, 40) : Point());
    const Angle angle(static_cast<std::int32_t>(random.below(Angle::kTurn)));
    if (!shape.turned(angle)) continue;
    const std::uint32_t part = 1 + i % 2;
    Entity entity(world, shape);
    MapPart(world, part).insert(entity, nearTheEdge(random, part), angle);
    if (i % 7 == 6) entity.destroy();
  }
  return world;
}

// Every instance in the part, by World::view.
std::vector<std::pair<std::uint32_t, InstanceView>> instancesIn(const World& world, std::uint32_t part) {
  std::vector<std::pair<std::uint32_t, InstanceView>> all;
  for (std::uint32_t i = 0; i < world.entities().size(); ++i) {
    if (!world.exists(i)) continue;
    for (const InstanceView& view : world.view(i)) {
      if (view.part == part) all.emplace_back(i, view);
    }
  }
  return all;
}

oracle::Vec vecOf(Point point) { return {point.x, point.y}; }

oracle::OpenArea areaOf(const World& world, std::uint32_t entity, const InstanceView& view) {
  oracle::Polygon polygon;
  const Convex turned = *world.shapeOf(entity).turned(view.angle);
  for (const Point vertex : turned.vertices()) polygon.push_back(vecOf(vertex));
  return oracle::OpenArea::placed(polygon, vecOf(view.position));
}

std::string where(int round) { return "seed " + std::to_string(kSeed) + ", round " + std::to_string(round); }

TEST(EntityQueryTest, FindsTheInstancesThatOverlapTheShape) {
  sim::SeededRandom random(kSeed);
  EntityQuery query;
  std::vector<FoundInstance> found;
  std::size_t total = 0;
  std::size_t further = 0;
  for (int round = 0; round < 300; ++round) {
    const World world = crowdedWorld(random);
    for (const std::uint32_t part : {1u, 2u}) {
      const Convex shape = randomConvex(random, 200);
      const Point position = nearTheEdge(random, part);
      query.overlapping(world, part, shape, position, found);
      std::size_t next = 0;
      for (const auto& [entity, view] : instancesIn(world, part)) {
        const Convex turned = *world.shapeOf(entity).turned(view.angle);
        if (!overlap(shape, position, turned, view.position)) continue;
        ASSERT_LT(next, found.size()) << where(round);
        ASSERT_EQ(found[next].entity, world.idOf(entity)) << where(round);
        ASSERT_EQ(found[next].instance, view.id);
        ASSERT_EQ(found[next].home, view.home);
        ASSERT_EQ(found[next].position, view.position);
        ASSERT_EQ(found[next].angle, view.angle);
        further += view.home ? 0 : 1;
        ++next;
      }
      ASSERT_EQ(next, found.size()) << where(round);
      total += next;
    }
  }
  EXPECT_GT(total, 1000u);
  EXPECT_GT(further, 10u);
}

TEST(EntityQueryTest, FindsTheInstancesThatTheOracleFindsOnTheRay) {
  sim::SeededRandom random(kSeed);
  EntityQuery query;
  std::vector<InstanceHit> hits;
  std::size_t total = 0;
  for (int round = 0; round < 300; ++round) {
    const World world = crowdedWorld(random);
    const Point from = nearTheEdge(random, 1);
    const Point displacement = round % 10 == 0 ? Point() : random.vector(800);
    query.onRay(world, 1, from, displacement, hits);
    std::size_t expected = 0;
    for (const auto& [entity, view] : instancesIn(world, 1)) {
      const auto area = areaOf(world, entity, view);
      if (!area.intersects({vecOf(from), vecOf(from + displacement)})) continue;
      ++expected;
      const auto is = [&, id = view.id, index = entity](const InstanceHit& hit) {
        return hit.found.entity.index == index && hit.found.instance == id;
      };
      const auto hit = std::find_if(hits.begin(), hits.end(), is);
      ASSERT_NE(hit, hits.end()) << where(round);
      const bool inside = area.intersects({vecOf(from), vecOf(from)});
      ASSERT_EQ(hit->normal == Point(), inside) << where(round);
      ASSERT_TRUE(inside || dot(hit->normal, displacement) < 0) << where(round);
      ASSERT_TRUE(!inside || hit->time == (Fraction{0, 1})) << where(round);
    }
    ASSERT_EQ(hits.size(), expected) << where(round);
    ASSERT_TRUE(std::is_sorted(hits.begin(), hits.end(), [](const InstanceHit& a, const InstanceHit& b) {
      return a.time < b.time || (a.time == b.time && a.found.entity.index < b.found.entity.index);
    })) << where(round);
    total += expected;
  }
  EXPECT_GT(total, 100u);
}

TEST(EntityQueryTest, TheTimeOfARayIsThatOfItsEntry) {
  World world = twoStrips();
  Entity box(world, square(10));
  MapPart(world, 1).insert(box, {100, 0}, Angle());
  EntityQuery query;
  std::vector<InstanceHit> hits;
  query.onRay(world, 1, {0, 0}, {180, 0}, hits);
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_EQ(hits[0].time, (Fraction{1, 2}));
  EXPECT_LT(hits[0].normal.x, 0);
  EXPECT_EQ(hits[0].normal.y, 0);
  query.onRay(world, 1, {0, 10}, {180, 0}, hits);
  EXPECT_TRUE(hits.empty()) << "it touches";
  query.onRay(world, 2, {0, 0}, {180, 0}, hits);
  EXPECT_TRUE(hits.empty()) << "another part";
  Entity(world, box.id()).destroy();
  query.onRay(world, 1, {0, 0}, {180, 0}, hits);
  EXPECT_TRUE(hits.empty());
}

TEST(EntityQueryTest, AnEntityOverAnEdgeIsFoundInBothParts) {
  World world = twoStrips();
  Entity box(world, square(100));
  MapPart(world, 1).insert(box, {950, 0}, Angle());
  EntityQuery query;
  std::vector<FoundInstance> found;
  query.overlapping(world, 1, square(5), {990, 0}, found);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(found[0].home);
  query.overlapping(world, 2, square(5), {-990, 0}, found);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_FALSE(found[0].home);
  EXPECT_EQ(found[0].entity, box.id());
}

TEST(EntityQueryTest, OneQueryMayServeSeveralWorlds) {
  World small = twoStrips();
  World large = twoStrips();
  Entity inSmall(small, square(10));
  Entity inLarge(large, square(50));
  MapPart(small, 1).insert(inSmall, {}, Angle::degrees(45));
  MapPart(large, 1).insert(inLarge, {}, Angle::degrees(45));
  EntityQuery query;
  std::vector<FoundInstance> found;
  for (int round = 0; round < 3; ++round) {
    query.overlapping(small, 1, square(1), {12, 12}, found);
    EXPECT_TRUE(found.empty()) << "beside the edge of the small diamond";
    query.overlapping(large, 1, square(1), {12, 12}, found);
    EXPECT_EQ(found.size(), 1u) << "inside the large one";
  }
}

TEST(EntityQueryTest, RefusesWhatIsOutOfRange) {
  World world = twoStrips();
  EntityQuery query;
  std::vector<FoundInstance> found;
  EXPECT_EQ(refusal([&] { query.overlapping(world, 7, square(1), {}, found); }),
            "query in map part 7: the part is not initialised");
  std::vector<InstanceHit> hits;
  EXPECT_NE(refusal([&] { query.onRay(world, 1, {0, 0}, {INT32_MAX, 0}, hits); }), "");
}

}  // namespace
}  // namespace platon::entity_query_test
