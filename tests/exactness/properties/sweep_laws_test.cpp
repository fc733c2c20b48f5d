// Laws that relate the answers to different sweep queries, on families of hard queries.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "platon/exact/integer.h"
#include "platon/physics/sweep.h"
#include "tests/exactness/oracle/sweep/sweep_families.h"
#include "tests/exactness/properties/lattice_map.h"
#include "tests/exactness/properties/seeded_cases.h"
#include "tests/exactness/step_check/conversions.h"
#include "tests/shared/physics/sweep_query.h"
#include "tests/support/run/repetitions.h"

namespace platon::properties::sweep_laws_test {
namespace {

using oracle::RandomSource;

std::string described(const SweepQuery& query) {
  return oracle::toLine({step_check::toPolygon(query.shape), step_check::toVec(query.position),
                         step_check::toVec(query.displacement), step_check::toSegment(query.segment)});
}

SweepQuery queryOf(const oracle::SweepFamily& family, RandomSource& random) {
  const oracle::SweepQuery made = oracle::makeQuery(family, random);
  return {step_check::toPoints(made.shape), step_check::toPoint(made.position), step_check::toPoint(made.displacement),
          step_check::toSegment(made.segment)};
}

// Calls `check` with one query of every family per case.
template <class Check>
void forEachQuery(std::int64_t cases, Check&& check) {
  std::int64_t hits = 0;
  std::int64_t misses = 0;
  forEachCase(cases, [&](RandomSource& random) {
    for (const oracle::SweepFamily& family : oracle::sweepFamilies()) {
      const SweepQuery query = queryOf(family, random);
      const std::optional<Hit> hit = answer(query);
      SCOPED_TRACE(described(query));
      check(query, hit, random);
      ++(hit ? hits : misses);
    }
  });
  EXPECT_GT(hits, misses / 10);
  EXPECT_GT(misses, hits / 10);
}

void expectSameTimes(const std::optional<Hit>& hit, const std::optional<Hit>& other) {
  ASSERT_EQ(other.has_value(), hit.has_value());
  if (!hit) return;
  EXPECT_EQ(other->time, hit->time);
  EXPECT_EQ(other->exit, hit->exit);
  EXPECT_EQ(other->side == Hit::Side::kInside, hit->side == Hit::Side::kInside);
}

bool inRange(Point point) { return isCoordinate(point.x) && isCoordinate(point.y); }

TEST(SweepLawsTest, AnswersAreSymmetric) {
  forEachQuery(repetitions(5000), [](const SweepQuery& query, const std::optional<Hit>& hit, RandomSource& random) {
    LatticeMap map = anyMap(random, kCoordinateLimit / 2);
    const auto fits = [&] {
      return inRange(map.place(query.position)) && inRange(map.place(query.segment.a)) &&
             inRange(map.place(query.segment.b));
    };
    if (!fits()) map.shift = {};
    const SweepQuery mapped{map.shape(query.shape), map.place(query.position), map.vector(query.displacement),
                            map.segment(query.segment)};
    const std::optional<Hit> other = answer(mapped);
    expectSameTimes(hit, other);
    // If two edges are hit at once, their order decides which is named. A reflection reverses that order.
    if (hit && other && !map.mirror) {
      EXPECT_EQ(other->normal, map.vector(hit->normal));
      EXPECT_EQ(other->side, hit->side);
    }
  });
}

TEST(SweepLawsTest, SegmentDirectionAndFirstVertexDoNotMatter) {
  forEachQuery(repetitions(5000), [](const SweepQuery& query, const std::optional<Hit>& hit, RandomSource& random) {
    SweepQuery other = query;
    std::swap(other.segment.a, other.segment.b);
    expectSameTimes(hit, answer(other));
    const auto first = random.between(0, static_cast<std::int64_t>(query.shape.size()) - 1);
    std::rotate(other.shape.begin(), other.shape.begin() + first, other.shape.end());
    expectSameTimes(hit, answer(other));
  });
}

TEST(SweepLawsTest, ALargerMarginNeitherLosesNorDelaysAHit) {
  forEachQuery(repetitions(5000), [](const SweepQuery& query, const std::optional<Hit>& hit, RandomSource& random) {
    std::optional<Hit> last = hit;
    for (std::int32_t margin = 0; margin < 64;) {
      margin += static_cast<std::int32_t>(random.between(1, 24));
      const std::optional<Hit> next = answer(query, margin);
      if (last) {
        ASSERT_TRUE(next.has_value()) << "margin " << margin;
        EXPECT_LE(next->time, last->time) << "margin " << margin;
        EXPECT_GE(next->exit, last->exit) << "margin " << margin;
      }
      last = next;
    }
  });
}

mpq_class rational(Fraction fraction) {
  mpq_class value(mpz_class(fraction.numerator), mpz_class(fraction.denominator));
  value.canonicalize();
  return value;
}

Point times(std::int64_t factor, Point vector) {
  return {static_cast<std::int32_t>(factor * vector.x), static_cast<std::int32_t>(factor * vector.y)};
}

// A displacement of equal steps: those before the hit are free, and one more step hits the segment at the same place.
TEST(SweepLawsTest, APartOfTheDisplacementHitsAtTheSamePlace) {
  forEachQuery(repetitions(5000), [](const SweepQuery& query, const std::optional<Hit>&, RandomSource& random) {
    const std::int64_t steps = random.between(1, 1000);
    SweepQuery whole = query;
    const Point step(query.displacement.x / static_cast<std::int32_t>(steps),
                     query.displacement.y / static_cast<std::int32_t>(steps));
    whole.displacement = times(steps, step);
    const std::optional<Hit> hit = answer(whole);
    const auto free =
        hit ? static_cast<std::int64_t>(int128{hit->time.numerator} * steps / hit->time.denominator) : steps;
    SweepQuery part = whole;
    part.displacement = times(free, step);
    EXPECT_EQ(answer(part).has_value(), hit && hit->side == Hit::Side::kInside) << free << " of " << steps;
    if (!hit) return;
    part.displacement = times(free + 1, step);
    const std::optional<Hit> shorter = answer(part);
    ASSERT_TRUE(shorter.has_value()) << free + 1 << " of " << steps;
    EXPECT_EQ(mpq_class(rational(hit->time) * steps), mpq_class(rational(shorter->time) * (free + 1)));
  });
}

}  // namespace
}  // namespace platon::properties::sweep_laws_test
