#include "platon/physics/sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>

#include "platon/exact/integer.h"
#include "tests/exactness/oracle/exact_geometry.h"
#include "tests/exactness/oracle/sweep/sweep_oracle.h"
#include "tests/shared/physics/shapes.h"
#include "tests/shared/physics/sweep_query.h"

namespace platon::sweep_test {
namespace {

constexpr std::uint64_t kSeed = 4711;
constexpr std::int32_t kMax = kCoordinateLimit - 1;

std::string textOf(Point point) { return "(" + std::to_string(point.x) + ", " + std::to_string(point.y) + ") "; }

std::string textOf(const SweepQuery& query) {
  std::string text = "seed " + std::to_string(kSeed) + ", shape ";
  for (const Point vertex : query.shape) text += textOf(vertex);
  return text + "at " + textOf(query.position) + "by " + textOf(query.displacement) + "line " +
         textOf(query.segment.a) + textOf(query.segment.b);
}

oracle::CorrectAnswer correctAnswerOf(const SweepQuery& query) {
  oracle::SweepQuery asked;
  for (const Point vertex : query.shape) asked.shape.push_back({vertex.x, vertex.y});
  asked.position = {query.position.x, query.position.y};
  asked.displacement = {query.displacement.x, query.displacement.y};
  asked.segment = {{query.segment.a.x, query.segment.a.y}, {query.segment.b.x, query.segment.b.y}};
  return correctAnswer(asked);
}

// Small numbers produce touching, tangential and coincident cases, large ones the bounds.
SweepQuery randomQuery(sim::SeededRandom& random, int round) {
  const std::int32_t scale = round % 2 == 0 ? 6 : 2 << (round % 23);
  SweepQuery query;
  query.shape = randomConvex(random, scale).vertices();
  query.position = random.vector(2 * scale);
  query.displacement = random.vector(4 * scale);
  const Point a = random.vector(3 * scale);
  query.segment = {a, round % 7 == 0 ? a : random.vector(3 * scale)};
  return query;
}

void forRandomQueries(int count, const std::function<void(const SweepQuery&)>& check) {
  sim::SeededRandom random(kSeed);
  for (int i = 0; i < count && !testing::Test::HasFatalFailure(); ++i) check(randomQuery(random, i));
}

void expectSameTimes(const std::optional<Hit>& a, const std::optional<Hit>& b, const SweepQuery& query) {
  ASSERT_EQ(a.has_value(), b.has_value()) << textOf(query);
  if (!a) return;
  ASSERT_EQ(a->time, b->time) << textOf(query);
  ASSERT_EQ(a->exit, b->exit) << textOf(query);
  ASSERT_EQ(a->side == Hit::Side::kInside, b->side == Hit::Side::kInside) << textOf(query);
}

SweepQuery mapped(const SweepQuery& query, const std::function<Point(Point)>& turn, Point shift) {
  SweepQuery image = query;
  for (Point& vertex : image.shape) vertex = turn(vertex);
  image.position = turn(query.position) + shift;
  image.displacement = turn(query.displacement);
  image.segment = {turn(query.segment.a) + shift, turn(query.segment.b) + shift};
  return image;
}

TEST(SweepTest, HitsASegmentHeadOn) {
  const auto hit = answer({square(10).vertices(), {0, 0}, {0, -40}, {{-50, -30}, {50, -30}}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->time, (Fraction{1, 2}));
  EXPECT_EQ(hit->exit, (Fraction{1, 1})) << "the overlap lasts to the end";
  EXPECT_EQ(cross(hit->normal, Point(0, 1)), 0);
  EXPECT_GT(hit->normal.y, 0);
  EXPECT_EQ(hit->side, Hit::Side::kSegment);
  EXPECT_EQ(hit->feature.y, -10);
}

TEST(SweepTest, HitsASegmentFromBothSides) {
  for (const int side : {-1, 1}) {
    const auto hit = answer({square(10).vertices(), {0, 0}, {0, 40 * side}, {{-50, 30 * side}, {50, 30 * side}}});
    ASSERT_TRUE(hit);
    EXPECT_LT(hit->normal.y * side, 0);
    EXPECT_EQ(hit->feature.y, 10 * side);
  }
}

TEST(SweepTest, HitsASegmentEndWithAnEdge) {
  const auto hit = answer({square(10).vertices(), {0, 0}, {0, -40}, {{3, -20}, {3, -60}}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->time, (Fraction{1, 4}));
  EXPECT_EQ(hit->side, Hit::Side::kSegmentEnd);
  EXPECT_EQ(hit->feature, Point(3, -20));
  EXPECT_EQ(cross(hit->normal, Point(0, 1)), 0);
}

TEST(SweepTest, HitsAPoint) {
  const auto hit = answer({square(10).vertices(), {0, 0}, {100, 0}, {{60, 9}, {60, 9}}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->time, (Fraction{1, 2}));
  EXPECT_EQ(hit->exit, (Fraction{7, 10}));
  EXPECT_EQ(hit->side, Hit::Side::kSegmentEnd);
  EXPECT_EQ(hit->feature, Point(60, 9));
  EXPECT_LT(hit->normal.x, 0);
  EXPECT_FALSE(answer({square(10).vertices(), {0, 0}, {100, 0}, {{60, 10}, {60, 10}}})) << "it only touches";
}

TEST(SweepTest, TouchingIsNotAHit) {
  const auto box = square(10).vertices();
  const Segment floor{{-50, -10}, {50, -10}};
  EXPECT_FALSE(answer({box, {0, 0}, {0, 0}, floor}));
  EXPECT_FALSE(answer({box, {0, 0}, {30, 0}, floor})) << "along";
  EXPECT_FALSE(answer({box, {0, 0}, {0, 7}, floor})) << "away";
  EXPECT_FALSE(answer({box, {0, 20}, {0, -20}, floor})) << "reached at time 1";
  EXPECT_FALSE(answer({box, {0, 0}, {0, -40}, {{10, -60}, {10, 60}}})) << "a wall that it slides along";
  EXPECT_FALSE(answer({box, {0, 0}, {20, -20}, {{20, 0}, {20, 10}}})) << "a vertex passes its end";
  EXPECT_TRUE(answer({box, {0, 20}, {0, -21}, floor}));
}

TEST(SweepTest, HitsATouchedSegmentImmediately) {
  const auto hit = answer({square(10).vertices(), {0, 0}, {3, -1}, {{-50, -10}, {50, -10}}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->time, (Fraction{0, 1}));
  EXPECT_EQ(hit->side, Hit::Side::kSegment);
  EXPECT_GT(hit->normal.y, 0);
}

TEST(SweepTest, InitialOverlapHasNoNormal) {
  for (const Point displacement : {Point(), Point(100, 0), Point(0, -1)}) {
    const auto hit = answer({square(10).vertices(), {0, 0}, displacement, {{-5, 0}, {-5, 40}}});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->time, (Fraction{0, 1}));
    EXPECT_EQ(hit->normal, Point());
    EXPECT_EQ(hit->side, Hit::Side::kInside);
  }
}

TEST(SweepTest, SidesTakePrecedenceOverEnds) {
  // Straight onto the end: the left side and an edge of the shape are entered at the same time.
  const auto hit = answer({square(10).vertices(), {0, 30}, {0, -40}, {{10, 0}, {50, 0}}});
  EXPECT_FALSE(hit) << "only touches";
  const auto corner = answer({{{-10, 0}, {0, -10}, {10, 0}, {0, 10}}, {0, 20}, {0, -20}, {{0, 0}, {50, 0}}});
  ASSERT_TRUE(corner);
  EXPECT_EQ(corner->time, (Fraction{1, 2}));
  EXPECT_EQ(corner->side, Hit::Side::kSegment);
  EXPECT_EQ(corner->feature, Point(0, -10));
}

TEST(SweepTest, AgreesWithTheOracle) {
  forRandomQueries(20000, [](const SweepQuery& query) {
    const oracle::CorrectAnswer correct = correctAnswerOf(query);
    const auto hit = answer(query);
    ASSERT_EQ(hit.has_value(), correct.kind != oracle::CorrectAnswer::Kind::Miss) << textOf(query);
    if (!hit) return;
    ASSERT_EQ(hit->side == Hit::Side::kInside, correct.kind == oracle::CorrectAnswer::Kind::Overlap) << textOf(query);
    ASSERT_TRUE(hit->time.numerator * correct.denominator == correct.numerator * hit->time.denominator)
        << textOf(query);
  });
}

TEST(SweepTest, IsTranslationInvariant) {
  forRandomQueries(20000, [](const SweepQuery& query) {
    const Point shift(1 << 27, -(1 << 26) - 5);
    const auto here = answer(query);
    const auto there = answer(mapped(
        query, [](Point p) { return p; }, shift));
    ASSERT_NO_FATAL_FAILURE(expectSameTimes(here, there, query));
    if (!here) return;
    ASSERT_EQ(here->normal, there->normal);
    ASSERT_EQ(here->side, there->side);
    const Point expected = here->side == Hit::Side::kSegmentEnd ? here->feature + shift : here->feature;
    ASSERT_EQ(there->feature, expected) << textOf(query);
  });
}

TEST(SweepTest, IsInvariantUnderQuarterTurns) {
  forRandomQueries(20000, [](const SweepQuery& query) {
    const auto here = answer(query);
    const auto turned = answer(mapped(query, perpendicular, {}));
    ASSERT_NO_FATAL_FAILURE(expectSameTimes(here, turned, query));
    if (!here) return;
    ASSERT_EQ(turned->normal, perpendicular(here->normal)) << textOf(query);
    ASSERT_EQ(turned->feature, perpendicular(here->feature)) << textOf(query);
    ASSERT_EQ(turned->side, here->side) << textOf(query);
  });
}

TEST(SweepTest, IsMirrorInvariant) {
  forRandomQueries(20000, [](const SweepQuery& query) {
    SweepQuery image = mapped(query, [](Point p) { return Point(-p.x, p.y); }, {});
    std::reverse(image.shape.begin(), image.shape.end());
    expectSameTimes(answer(query), answer(image), query);
  });
}

TEST(SweepTest, IsIndependentOfTheDirectionOfTheSegment) {
  forRandomQueries(20000, [](const SweepQuery& query) {
    SweepQuery reversed = query;
    std::swap(reversed.segment.a, reversed.segment.b);
    const auto forth = answer(query);
    const auto back = answer(reversed);
    ASSERT_NO_FATAL_FAILURE(expectSameTimes(forth, back, query));
    if (!forth) return;
    ASSERT_EQ(forth->normal, back->normal) << textOf(query);
    ASSERT_EQ(forth->side, back->side) << textOf(query);
    ASSERT_EQ(forth->feature, back->feature) << textOf(query);
  });
}

TEST(SweepTest, HitsASegmentWhereItsPartsAreHit) {
  sim::SeededRandom random(kSeed);
  for (int i = 0; i < 20000; ++i) {
    SweepQuery query = randomQuery(random, i);
    const Point step = random.vector(5);
    const auto parts = 1 + static_cast<std::int32_t>(random.below(6));
    const auto cut = static_cast<std::int32_t>(random.below(static_cast<std::uint64_t>(parts) + 1));
    const auto along = [&](std::int32_t n) { return query.segment.a + Point(step.x * n, step.y * n); };
    SweepQuery first = query;
    SweepQuery second = query;
    first.segment.b = second.segment.a = along(cut);
    query.segment.b = second.segment.b = along(parts);
    const auto whole = answer(query);
    const auto a = answer(first);
    const auto b = answer(second);
    ASSERT_EQ(whole.has_value(), a.has_value() || b.has_value()) << textOf(query);
    if (!whole) continue;
    const Fraction earliest = !a ? b->time : !b ? a->time : std::min(a->time, b->time);
    const Fraction latest = !a ? b->exit : !b ? a->exit : std::max(a->exit, b->exit);
    ASSERT_EQ(whole->time, earliest) << textOf(query);
    ASSERT_EQ(whole->exit, latest) << textOf(query);
  }
}

// The reversed sweep enters where the original exits, and exits where it enters.
TEST(SweepTest, ReversedSweepsExchangeTimeAndExit) {
  forRandomQueries(20000, [](const SweepQuery& query) {
    SweepQuery reversed = query;
    reversed.position = query.position + query.displacement;
    reversed.displacement = -query.displacement;
    const auto forth = answer(query);
    const auto back = answer(reversed);
    ASSERT_EQ(forth.has_value(), back.has_value()) << textOf(query);
    if (!forth) return;
    const auto mirrored = [](Fraction time) { return Fraction{time.denominator - time.numerator, time.denominator}; };
    ASSERT_EQ(back->time, mirrored(forth->exit)) << textOf(query);
    ASSERT_EQ(back->exit, mirrored(forth->time)) << textOf(query);
    ASSERT_LT(forth->time, forth->exit) << textOf(query);
  });
}

// At each twelfth of the displacement, the shape overlaps the segment exactly when the time is between `time` and
// `exit`.
TEST(SweepTest, OverlapsOnlyBetweenTimeAndExit) {
  forRandomQueries(4000, [](const SweepQuery& query) {
    constexpr std::int32_t parts = 12;
    const auto hit = answer(query);
    const auto scaled = [](Point p) { return oracle::Vec{std::int64_t{p.x} * parts, std::int64_t{p.y} * parts}; };
    oracle::Polygon shape;
    for (const Point vertex : query.shape) shape.push_back(scaled(vertex));
    for (std::int32_t part = 0; part <= parts; ++part) {
      const oracle::Vec at = scaled(query.position) + part * oracle::Vec{query.displacement.x, query.displacement.y};
      const bool overlaps =
          oracle::OpenArea::placed(shape, at).intersects({scaled(query.segment.a), scaled(query.segment.b)});
      const Fraction time{part, parts};
      const bool within = hit && time < hit->exit && (time > hit->time || hit->side == Hit::Side::kInside);
      // An exit of 1 does not say whether the shape overlaps at the end.
      if (part == parts && hit && hit->exit == Fraction{1, 1}) continue;
      ASSERT_EQ(overlaps, within) << textOf(query) << "part " << part;
    }
  });
}

TEST(SweepTest, NormalFacesTheShapeAndTheFeatureTouches) {
  int lines = 0;
  int ends = 0;
  forRandomQueries(20000, [&](const SweepQuery& query) {
    const auto hit = answer(query);
    if (!hit || hit->side == Hit::Side::kInside) return;
    ASSERT_LT(dot(hit->normal, query.displacement), 0) << textOf(query);
    // normal . (position + time * displacement + vertex - end) = 0, times the denominator.
    const auto gap = [&](Point vertex, Point end) {
      return int128{dot(hit->normal, query.position + vertex - end)} * hit->time.denominator +
             int128{dot(hit->normal, query.displacement)} * hit->time.numerator;
    };
    const auto isVertex = [&](Point point) {
      return std::find(query.shape.begin(), query.shape.end(), point) != query.shape.end();
    };
    if (hit->side == Hit::Side::kSegment) {
      ++lines;
      ASSERT_TRUE(isVertex(hit->feature)) << textOf(query);
      ASSERT_EQ(dot(hit->normal, query.segment.b - query.segment.a), 0) << textOf(query);
      ASSERT_TRUE(gap(hit->feature, query.segment.a) == 0) << textOf(query);
      return;
    }
    ++ends;
    ASSERT_TRUE(hit->feature == query.segment.a || hit->feature == query.segment.b) << textOf(query);
    ASSERT_EQ(std::count_if(query.shape.begin(), query.shape.end(),
                            [&](Point vertex) { return gap(vertex, hit->feature) == 0; }),
              2)
        << textOf(query);
  });
  EXPECT_GT(lines, 500);
  EXPECT_GT(ends, 500);
}

TEST(SweepTest, LargerMarginsHitEarlierAndExitLater) {
  forRandomQueries(20000, [](const SweepQuery& query) {
    std::optional<Hit> smaller = answer(query);
    for (const std::int32_t margin : {1, 2, 4, 8, 100}) {
      const auto larger = answer(query, margin);
      if (smaller) {
        ASSERT_TRUE(larger) << textOf(query) << "margin " << margin;
        ASSERT_LE(larger->time, smaller->time) << textOf(query) << "margin " << margin;
        ASSERT_GE(larger->exit, smaller->exit) << textOf(query) << "margin " << margin;
      }
      smaller = larger;
    }
  });
}

TEST(SweepTest, EdgesMoveByAtLeastTheMargin) {
  const auto box = square(10).vertices();
  for (const std::int32_t margin : {1, 4, 8}) {
    const Segment line{{10 + margin, -5}, {10 + margin, 5}};
    EXPECT_FALSE(answer({box, {0, 0}, {}, line}, margin)) << "an axis-parallel edge moves by the margin exactly";
    EXPECT_TRUE(answer({box, {1, 0}, {}, line}, margin));
  }
}

TEST(SweepTest, BoundsContainTheWholePath) {
  const Convex shape = square(10);
  Sweep sweep;
  sweep.start(shape, {100, -100}, {-7, 5}, 3);
  EXPECT_EQ(sweep.bounds().low, Point(80, -113));
  EXPECT_EQ(sweep.bounds().high, Point(113, -82));
}

TEST(SweepTest, IsExactAtTheEndsOfTheRange) {
  const std::vector<Point> huge{{-kMax, -kMax}, {kMax, -kMax}, {kMax, kMax}, {-kMax, kMax}};
  const auto touch = answer({huge, {kMax, kMax}, {-kMax, -kMax}, {{-kMax, kMax}, {kMax, -kMax}}});
  ASSERT_TRUE(touch);
  EXPECT_EQ(touch->time, (Fraction{0, 1}));
  const std::vector<Point> sliver{{-kMax, -kMax}, {kMax, kMax - 1}, {kMax, kMax}};
  const auto hit = answer({sliver, {kMax, -kMax}, {-2 * kMax, 2 * kMax}, {{-kMax, -kMax}, {kMax, kMax}}});
  ASSERT_TRUE(hit);
  EXPECT_LT(hit->time, (Fraction{1, 1}));
  // A segment that deviates from the diagonal by one subunit over the whole range: near its ends it is 2^-30 subunits
  // from lattice points.
  const std::vector<Point> above{{0, 0}, {1, 1}, {0, 1}};
  const Segment diagonal{{-kMax, -kMax}, {kMax, kMax - 1}};
  EXPECT_FALSE(answer({above, {-kMax, -kMax}, {}, diagonal}));
  EXPECT_TRUE(answer({above, {-kMax + 1, -kMax}, {}, diagonal}));
  EXPECT_FALSE(answer({above, {kMax - 2, kMax - 2}, {}, diagonal}));
  EXPECT_TRUE(answer({above, {kMax - 2, kMax - 3}, {}, diagonal}));
}

TEST(SweepTest, LargestQueriesAgreeWithTheOracle) {
  sim::SeededRandom random(kSeed);
  const auto corner = [&] {
    const auto near = [&] { return static_cast<std::int32_t>(random.below(4)) * (random.below(2) == 0 ? 1 : 1 << 14); };
    const std::int32_t x = kMax - near();
    const std::int32_t y = kMax - near();
    return Point(random.below(2) == 0 ? x : -x, random.below(2) == 0 ? y : -y);
  };
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    std::vector<Point> hull = convexHull({corner(), corner(), corner(), corner(), corner()});
    if (Convex::fault(hull)) continue;
    const SweepQuery query{hull, corner(), corner(), {corner(), corner()}};
    const oracle::CorrectAnswer correct = correctAnswerOf(query);
    const auto hit = answer(query);
    ASSERT_EQ(hit.has_value(), correct.kind != oracle::CorrectAnswer::Kind::Miss) << textOf(query);
    if (!hit) continue;
    ++hits;
    ASSERT_TRUE(hit->time.numerator * correct.denominator == correct.numerator * hit->time.denominator)
        << textOf(query);
  }
  EXPECT_GT(hits, 1000);
}

}  // namespace
}  // namespace platon::sweep_test
