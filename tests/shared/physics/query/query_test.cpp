#include "platon/physics/query.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "platon/physics/map_part.h"
#include "tests/exactness/oracle/exact_geometry.h"
#include "tests/shared/physics/maps.h"
#include "tests/shared/physics/refusal.h"
#include "tests/shared/physics/shapes.h"

namespace platon::query_test {
namespace {

constexpr std::uint64_t kSeed = 20261123;
constexpr std::int32_t kMax = kCoordinateLimit - 1;

oracle::Vec vecOf(Point point) { return {point.x, point.y}; }

// A map part of random segments, among them points, repeated ones and two warps, in a world of its own.
struct RandomPart {
  RandomPart(sim::SeededRandom& random, std::int32_t scale, int count) {
    MapPart part(world, 1);
    Segment last{};
    for (int i = 0; i < count; ++i) {
      const Point a = random.vector(scale);
      const Point b = random.vector(scale);
      if (i % 11 != 10) last = {a, i % 7 == 6 ? a : b};
      part.line(last.a, last.b);
    }
    const std::int32_t edge = scale + scale / 4;
    part.warp({edge, -edge}, {edge, edge}, 2, {-edge, -edge}, {-edge, edge});
    part.warp({-edge, edge}, {-edge, -edge}, 2, {edge, edge}, {edge, -edge});
    part.initialize();
  }
  const std::vector<Segment>& segments() const { return world.geometry().find(1)->segments; }

  World world;
};

// Of the closed segments from `from` to `to` and `other`: whether they have a common point, by orientations alone.
bool haveCommonPoint(oracle::Vec from, oracle::Vec to, const Segment& other) {
  const oracle::Vec a = vecOf(other.a);
  const oracle::Vec b = vecOf(other.b);
  const auto side = [](oracle::Vec p, oracle::Vec q, oracle::Vec r) { return oracle::sign(cross(q - p, r - p)); };
  if (side(from, to, a) * side(from, to, b) > 0 || side(a, b, from) * side(a, b, to) > 0) return false;
  const oracle::Box box{{std::min(from.x, to.x), std::min(from.y, to.y)},
                        {std::max(from.x, to.x), std::max(from.y, to.y)}};
  return box.touches(oracle::boxOf(oracle::Segment{a, b}));
}

// Checks a time by the definition: at `time` the point is on the segment. In 128 bits, for coordinates below 2^20.
bool isOnSegment(Point from, Point displacement, Fraction time, const Segment& segment) {
  using oracle::Wide;
  const auto at = [&](std::int32_t start, std::int32_t change) {
    return Wide{start} * time.denominator + Wide{change} * time.numerator;
  };
  const Wide x = at(from.x, displacement.x);
  const Wide y = at(from.y, displacement.y);
  const auto scaled = [&](std::int32_t value) { return Wide{value} * time.denominator; };
  const Wide turn =
      (x - scaled(segment.a.x)) * (segment.b.y - segment.a.y) - (y - scaled(segment.a.y)) * (segment.b.x - segment.a.x);
  const Box box = boundsOf(segment);
  return turn == 0 && x >= scaled(box.low.x) && x <= scaled(box.high.x) && y >= scaled(box.low.y) &&
         y <= scaled(box.high.y);
}

struct RandomPath {
  RandomPath(sim::SeededRandom& random, std::int32_t scale, const std::vector<Segment>& segments)
      : from(random.vector(scale)), displacement(random.vector(2 * scale)) {
    const Segment& one = segments[random.below(segments.size())];
    switch (random.below(8)) {
      case 0:
        displacement = {};
        break;
      case 1:
        displacement.y = 0;
        break;
      case 2:
        displacement.x = 0;
        break;
      case 3:
        from = one.a;
        break;  // starts at an end
      case 4:
        displacement = one.b - from;
        break;  // ends at an end
      case 5:
        from = one.a, displacement = one.b - one.a;
        break;  // along a segment
      default:
        break;
    }
  }
  Point from;
  Point displacement;
};

constexpr std::array<std::int32_t, 4> kScales{6, 40, 3000, 1 << 18};

std::string where(int round) { return "seed " + std::to_string(kSeed) + ", round " + std::to_string(round); }

TEST(QueryTest, RaysMeetExactlyTheSegmentsWithACommonPoint) {
  sim::SeededRandom random(kSeed);
  std::vector<RayHit> hits;
  std::size_t met = 0;
  for (int round = 0; round < 4000; ++round) {
    const std::int32_t scale = kScales[static_cast<std::size_t>(round) % kScales.size()];
    const RandomPart part(random, scale, 1 + static_cast<int>(random.below(120)));
    const RandomPath path(random, scale, part.segments());
    castRayThrough(part.world, 1, path.from, path.displacement, hits);
    std::vector<bool> found(part.segments().size());
    for (const RayHit& hit : hits) {
      ASSERT_FALSE(found[hit.segment.index]) << "twice, " << where(round);
      found[hit.segment.index] = true;
      ASSERT_EQ(hit.segment.ends, part.segments()[hit.segment.index]);
      ASSERT_EQ(hit.segment.warp, hit.segment.index >= part.segments().size() - 2);
      ASSERT_TRUE(isOnSegment(path.from, path.displacement, hit.time, hit.segment.ends)) << where(round);
      ASSERT_LE(dot(hit.normal, path.displacement), 0) << where(round);
    }
    for (std::size_t i = 0; i < found.size(); ++i) {
      ASSERT_EQ(found[i], haveCommonPoint(vecOf(path.from), vecOf(path.from + path.displacement), part.segments()[i]))
          << "segment " << i << ", " << where(round);
    }
    ASSERT_TRUE(std::is_sorted(hits.begin(), hits.end(), [](const RayHit& a, const RayHit& b) {
      return a.time < b.time || (a.time == b.time && a.segment.index < b.segment.index);
    })) << where(round);
    const auto first = castRay(part.world, 1, path.from, path.displacement);
    ASSERT_EQ(first.has_value(), !hits.empty()) << where(round);
    if (!first) continue;
    ASSERT_EQ(first->segment.index, hits[0].segment.index) << where(round);
    ASSERT_EQ(first->time, hits[0].time) << where(round);
    met += hits.size();
  }
  EXPECT_GT(met, 10000u);
}

// A time is the first one: no earlier point of the ray is on the segment, so the ray up to the middle of the way there
// has no common point with it.
TEST(QueryTest, TheTimeOfARayIsTheFirst) {
  sim::SeededRandom random(kSeed);
  std::vector<RayHit> hits;
  int checked = 0;
  for (int round = 0; round < 3000; ++round) {
    const RandomPart part(random, 40, 60);
    RandomPath path(random, 20, part.segments());
    path.displacement = path.displacement - Point(path.displacement.x % 2, path.displacement.y % 2);
    castRayThrough(part.world, 1, path.from, path.displacement, hits);
    const Point half(path.displacement.x / 2, path.displacement.y / 2);
    for (const RayHit& hit : hits) {
      const bool early = haveCommonPoint(vecOf(path.from), vecOf(path.from + half), hit.segment.ends);
      ASSERT_EQ(hit.time <= (Fraction{1, 2}), early) << where(round);
      ++checked;
    }
  }
  EXPECT_GT(checked, 3000);
}

TEST(QueryTest, ShapesMeetWhatAnExactSweepOfEverySegmentMeets) {
  sim::SeededRandom random(kSeed);
  std::vector<ShapeHit> hits;
  std::size_t met = 0;
  for (int round = 0; round < 3000; ++round) {
    const std::int32_t scale = kScales[static_cast<std::size_t>(round) % kScales.size()];
    const RandomPart part(random, scale, 1 + static_cast<int>(random.below(120)));
    const RandomPath path(random, scale, part.segments());
    const Convex shape = randomConvex(random, std::max(4, scale / 4));
    castShapeThrough(part.world, 1, shape, path.from, path.displacement, hits);
    Sweep sweep;
    sweep.start(shape, path.from, path.displacement);
    std::optional<ShapeHit> best;
    std::size_t count = 0;
    for (std::uint32_t i = 0; i < part.segments().size(); ++i) {
      const auto hit = sweep.against(part.segments()[i]);
      if (!hit) continue;
      ++count;
      if (!best || hit->time < best->hit.time) best = ShapeHit{{1, i, false, part.segments()[i]}, *hit};
      const auto found = std::find_if(hits.begin(), hits.end(), [&](const auto& h) { return h.segment.index == i; });
      ASSERT_NE(found, hits.end()) << where(round);
      ASSERT_EQ(found->hit.time, hit->time);
      ASSERT_EQ(found->hit.normal, hit->normal);
    }
    ASSERT_EQ(hits.size(), count) << where(round);
    const auto first = castShape(part.world, 1, shape, path.from, path.displacement);
    ASSERT_EQ(first.has_value(), best.has_value()) << where(round);
    if (!best) continue;
    ASSERT_EQ(first->hit.time, best->hit.time) << where(round);
    ASSERT_EQ(first->segment.index, best->segment.index) << where(round);
    ASSERT_EQ(hits[0].segment.index, best->segment.index) << where(round);
    met += count;
  }
  EXPECT_GT(met, 10000u);
}

TEST(QueryTest, OverlapsAreThoseOfTheOracle) {
  sim::SeededRandom random(kSeed);
  std::vector<SegmentRef> found;
  std::size_t overlaps = 0;
  for (int round = 0; round < 3000; ++round) {
    const std::int32_t scale = kScales[static_cast<std::size_t>(round) % kScales.size()];
    const RandomPart part(random, scale, 1 + static_cast<int>(random.below(120)));
    const Convex shape = randomConvex(random, std::max(4, scale / 2));
    const Point position = random.vector(scale);
    oracle::Polygon polygon;
    for (const Point vertex : shape.vertices()) polygon.push_back(vecOf(vertex));
    const auto area = oracle::OpenArea::placed(polygon, vecOf(position));
    std::vector<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < part.segments().size(); ++i) {
      const Segment& segment = part.segments()[i];
      if (area.intersects({vecOf(segment.a), vecOf(segment.b)})) expected.push_back(i);
    }
    findOverlaps(part.world, 1, shape, position, found);
    std::vector<std::uint32_t> indices;
    for (const SegmentRef& segment : found) indices.push_back(segment.index);
    ASSERT_EQ(indices, expected) << where(round);
    ASSERT_EQ(overlapsSegment(part.world, 1, shape, position), !expected.empty()) << where(round);
    overlaps += expected.size();
  }
  EXPECT_GT(overlaps, 10000u);
}

// Two open convex polygons overlap if an edge of one crosses the inside of the other, or one lies inside the other.
TEST(QueryTest, ShapesOverlapAsTheOracleSays) {
  sim::SeededRandom random(kSeed);
  int overlaps = 0;
  for (int round = 0; round < 20000; ++round) {
    const std::int32_t scale = kScales[static_cast<std::size_t>(round) % kScales.size()];
    const Convex a = randomConvex(random, scale);
    const Convex b = round % 5 == 0 ? a : randomConvex(random, scale);
    const Point at = random.vector(scale);
    const Point bt = round % 10 == 0 ? at : random.vector(2 * scale);
    const auto areaOf = [](const Convex& shape, Point position) {
      oracle::Polygon polygon;
      for (const Point vertex : shape.vertices()) polygon.push_back(vecOf(vertex));
      return oracle::OpenArea::placed(polygon, vecOf(position));
    };
    // Every chord of a polygon between two of its vertices; an inner point of a triangle of them is not needed: if the
    // interiors meet, an edge or a diagonal of one has a point inside of the other.
    const auto chordEnters = [](const Convex& shape, Point position, const oracle::OpenArea& area) {
      const auto& v = shape.vertices();
      for (std::size_t i = 0; i < v.size(); ++i) {
        for (std::size_t k = i + 1; k < v.size(); ++k) {
          if (area.intersects({vecOf(v[i] + position), vecOf(v[k] + position)})) return true;
        }
      }
      return false;
    };
    const bool same = a == b && at == bt;
    const bool expected = same || chordEnters(a, at, areaOf(b, bt)) || chordEnters(b, bt, areaOf(a, at));
    ASSERT_EQ(overlap(a, at, b, bt), expected) << where(round);
    ASSERT_EQ(overlap(b, bt, a, at), expected) << where(round);
    overlaps += expected ? 1 : 0;
  }
  EXPECT_GT(overlaps, 5000);
  EXPECT_LT(overlaps, 15000);
}

TEST(QueryTest, TouchingIsAHitOfARayButNotOfAShape) {
  World world;
  addPart(world, 0, {{{0, 0}, {100, 0}}, {{50, 7}, {50, 7}}});
  EXPECT_EQ(castRay(world, 0, {-5, 0}, {5, 0})->time, (Fraction{1, 1}));
  EXPECT_EQ(castRay(world, 0, {-5, 0}, {5, 0})->normal, Point(-5, 0)) << "parallel to the ray";
  EXPECT_EQ(castRay(world, 0, {50, 9}, {0, -4})->segment.index, 1u) << "a point";
  EXPECT_EQ(castRay(world, 0, {30, 10}, {0, -40})->time, (Fraction{1, 4}));
  EXPECT_EQ(castRay(world, 0, {30, 10}, {0, -40})->normal, Point(0, 100));
  EXPECT_EQ(castRay(world, 0, {30, -10}, {0, 40})->normal, Point(0, -100)) << "the side that faces the start";
  EXPECT_EQ(castRay(world, 0, {50, 7}, {})->segment.index, 1u);
  EXPECT_FALSE(castRay(world, 0, {50, 8}, {}));
  EXPECT_FALSE(castShape(world, 0, square(5), {20, 15}, {0, -10})) << "ends on the segment";
  EXPECT_EQ(castShape(world, 0, square(5), {20, 15}, {0, -20})->hit.time, (Fraction{1, 2}));
  EXPECT_FALSE(overlapsSegment(world, 0, square(5), {20, 5}));
  EXPECT_TRUE(overlapsSegment(world, 0, square(5), {20, 4}));
  EXPECT_FALSE(overlap(square(5), {0, 0}, square(5), {10, 3}));
  EXPECT_TRUE(overlap(square(5), {0, 0}, square(5), {9, 3}));
}

TEST(QueryTest, OfEqualTimesTheLowestIndexComesFirst) {
  World world;
  addPart(world, 0, {{{0, 50}, {0, 100}}, {{-5, 40}, {5, 60}}, {{5, 40}, {-5, 60}}, {{-9, 50}, {9, 50}}});
  std::vector<RayHit> hits;
  castRayThrough(world, 0, {0, 0}, {0, 200}, hits);
  ASSERT_EQ(hits.size(), 4u);
  for (std::uint32_t i = 0; i < 4; ++i) EXPECT_EQ(hits[i].segment.index, i);
  EXPECT_EQ(castRay(world, 0, {0, 200}, {0, -200})->segment.index, 0u);
  EXPECT_EQ(castRay(world, 0, {-50, 50}, {100, 0})->segment.index, 3u);
}

TEST(QueryTest, TheFilterLeavesOutWallsWarpsOrOneSegment) {
  World world = twoStrips({{{500, -50}, {500, 50}}, {{600, -50}, {600, 50}}});
  const auto first = [&](const SegmentFilter& filter) { return castRay(world, 1, {0, 0}, {3000, 0}, filter); };
  EXPECT_EQ(first({})->segment.index, 0u);
  EXPECT_EQ(first({.except = 0})->segment.index, 1u);
  const auto warp = first({.walls = false});
  EXPECT_TRUE(warp->segment.warp);
  EXPECT_EQ(warp->time, (Fraction{1, 3}));
  EXPECT_FALSE(first({.walls = false, .warps = false}));
  std::vector<SegmentRef> found;
  findOverlaps(world, 1, square(900), {300, 0}, found, {.warps = false});
  EXPECT_EQ(found.size(), 2u);
  findOverlaps(world, 1, square(900), {300, 0}, found);
  EXPECT_EQ(found.size(), 3u);
}

TEST(QueryTest, EveryHitHasTheTagOfItsSegment) {
  World world;
  MapPart part(world, 1);
  part.line({100, -100}, {100, 100});
  part.line({200, -100}, {200, 100}, 7);
  part.initialize();
  std::vector<RayHit> rays;
  castRayThrough(world, 1, {0, 0}, {300, 0}, rays);
  ASSERT_EQ(rays.size(), 2u);
  EXPECT_EQ(rays[0].segment.tag, 0u);
  EXPECT_EQ(rays[1].segment.tag, 7u);
  EXPECT_EQ(castShape(world, 1, square(10), {150, 0}, {300, 0})->segment.tag, 7u);
  std::vector<SegmentRef> found;
  findOverlaps(world, 1, square(10), {200, 0}, found);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].tag, 7u);
}

TEST(QueryTest, HoldsAtTheLimitsOfTheCoordinates) {
  World world;
  addPart(world, 0, {{{-kMax, kMax}, {kMax, -kMax}}, {{kMax, kMax}, {kMax, kMax}}});
  const auto hit = castRay(world, 0, {-kMax, -kMax}, {2 * kMax, 2 * kMax});
  EXPECT_EQ(hit->segment.index, 0u);
  EXPECT_EQ(hit->time, (Fraction{1, 2}));
  EXPECT_EQ(pointAt({-kMax, -kMax}, {2 * kMax, 2 * kMax}, hit->time), PrecisePoint());
  std::vector<RayHit> hits;
  castRayThrough(world, 0, {-kMax, -kMax}, {2 * kMax, 2 * kMax}, hits);
  ASSERT_EQ(hits.size(), 2u);
  EXPECT_EQ(hits[1].time, (Fraction{1, 1}));
  EXPECT_TRUE(overlap(square(kMax), {kMax, kMax}, square(kMax), {2 - kMax, 2 - kMax}));
  EXPECT_FALSE(overlap(square(kMax), {kMax, kMax}, square(kMax), {-kMax, -kMax}));
}

TEST(QueryTest, RefusesWhatIsOutOfRange) {
  World world = twoStrips();
  EXPECT_EQ(refusal([&] { castRay(world, 7, {}, {}); }), "query in map part 7: the part is not initialised");
  const std::string range = ": an end is out of range: coordinates must be below 2^29 in magnitude";
  EXPECT_EQ(refusal([&] { castRay(world, 1, {kMax + 1, 0}, {}); }), "query from (536870912, 0) by (0, 0)" + range);
  EXPECT_EQ(refusal([&] {
              castShape(world, 1, square(1), {0, -5}, {0, -kMax});
            }),
            "query from (0, -5) by (0, -536870911)" + range);
  EXPECT_EQ(refusal([&] {
              overlapsSegment(world, 1, square(1), {0, INT32_MIN});
            }),
            "query from (0, -2147483648) by (0, 0)" + range);
}

TEST(QueryTest, ARayGoesOnBehindAWarp) {
  World world = twoStrips({}, {{{0, -500}, {0, 500}}});
  const auto hit = castRayOverWarps(world, 1, {900, 0}, {2000, 200}, 1);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->hit.segment.part, 2u);
  EXPECT_EQ(hit->hit.segment.index, 0u);
  EXPECT_EQ(hit->warps, 1);
  EXPECT_EQ(hit->from, Point(-1000, 10));
  EXPECT_EQ(hit->displacement, Point(1900, 190));
  EXPECT_EQ(rounded(pointAt(hit->from, hit->displacement, hit->hit.time)), Point(0, 110));
  EXPECT_FALSE(castRayOverWarps(world, 1, {900, 0}, {2000, 200}, 0));
  EXPECT_FALSE(castRayOverWarps(world, 1, {900, 0}, {1000, 100}, 1)) << "ends before the wall";
}

TEST(QueryTest, ARayThatStartsOnAWarpLeavesThePartOnlyOutwards) {
  World world = twoStrips({{{0, -500}, {0, 500}}, {{900, 200}, {1000, 200}}}, {{{0, -500}, {0, 500}}});
  EXPECT_EQ(castRayOverWarps(world, 1, {1000, 0}, {2000, 0}, 9)->hit.segment.part, 2u);
  EXPECT_EQ(castRayOverWarps(world, 1, {1000, 0}, {-2000, 0}, 9)->hit.segment.part, 1u);
  EXPECT_EQ(castRayOverWarps(world, 1, {1000, 0}, {-2000, 0}, 9)->warps, 0);
  const auto along = castRayOverWarps(world, 1, {1000, 0}, {0, 300}, 9);
  ASSERT_TRUE(along) << "the wall that ends on the warp";
  EXPECT_EQ(along->hit.segment.index, 1u);
  EXPECT_EQ(along->warps, 0);
}

TEST(QueryTest, ARayEndsAtAWarpWithoutAReverseWarp) {
  World world;
  addLeftStrip(world);
  addPart(world, 2, {{{0, -500}, {0, 500}}});
  EXPECT_FALSE(castRayOverWarps(world, 1, {0, 0}, {5000, 0}, 9));
}

}  // namespace
}  // namespace platon::query_test
