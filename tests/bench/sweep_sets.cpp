#include "tests/bench/sweep_sets.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "platon/exact/integer.h"
#include "tests/shared/physics/shapes.h"
#include "tests/sim/seeded_random.h"

namespace platon::bench {
namespace {

constexpr std::uint64_t kSeed = 12;
constexpr std::size_t kShapes = 32;
constexpr std::int32_t kRadius = 12 * kSubunitsPerUnit;  // radius of a player
constexpr std::int32_t kSpeed = 3 * kRadius;
constexpr std::int32_t kFarScale = 4096;  // subunits per metre in far-1e5

using sim::SeededRandom;
using Make = std::function<SweepQuery(SeededRandom&, const Convex&)>;
using MakeShapes = std::function<std::vector<Convex>(SeededRandom&)>;

// Regular polygons with radii in [minRadius, 2 * minRadius * 2^spread), at random angles.
MakeShapes polygons(int count, std::int32_t minRadius = kRadius / 2, std::uint64_t spread = 1) {
  return [=](SeededRandom& random) {
    std::vector<Convex> shapes;
    while (shapes.size() < kShapes) {
      const auto doublings = random.below(spread);
      const auto radius = static_cast<std::int32_t>((static_cast<std::uint64_t>(minRadius) << doublings) +
                                                    random.below(static_cast<std::uint64_t>(minRadius)));
      const Angle angle(static_cast<std::int32_t>(random.below(Angle::kTurn)));
      if (const auto turned = regular(count, radius).turned(angle)) shapes.push_back(*turned);
    }
    return shapes;
  };
}

SweepSet setOf(const std::string& name, std::size_t queries, const Make& make,
               const MakeShapes& makeShapes = polygons(8)) {
  SeededRandom random(kSeed);
  SweepSet set{.name = name, .shapes = makeShapes(random), .queries = {}};
  for (std::size_t i = 0; i < queries; ++i) {
    const auto shape = static_cast<std::size_t>(random.below(set.shapes.size()));
    SweepQuery query = make(random, set.shapes[shape]);
    query.shape = shape;
    set.queries.push_back(query);
  }
  return set;
}

SweepQuery randomQuery(SeededRandom& random, const Convex&) {
  const Point a = random.vector(4 * kRadius);
  return {0, random.vector(kRadius), random.vector(kSpeed), {a, a + random.vector(6 * kRadius)}};
}

SweepQuery shifted(SweepQuery query, Point by) {
  query.position = query.position + by;
  query.segment = {query.segment.a + by, query.segment.b + by};
  return query;
}

Make farAway(std::int32_t distance) {
  return [distance](SeededRandom& random, const Convex& shape) {
    return shifted(randomQuery(random, shape),
                   rotate(Point(distance, 0), Angle(static_cast<std::int32_t>(random.below(Angle::kTurn)))));
  };
}

// The vertex farthest in `direction`.
Point farthest(const Convex& shape, Point direction) {
  return *std::max_element(shape.vertices().begin(), shape.vertices().end(),
                           [&](Point u, Point v) { return dot(direction, u) < dot(direction, v); });
}

// A random vector with components of up to `limit`, in the half plane of `side`.
Point towards(SeededRandom& random, Point side, std::int32_t limit) {
  const Point vector = random.vector(limit);
  return dot(vector, side) < 0 ? Point() - vector : vector;
}

// The outermost vertex on one side passes the end of the segment within two subunits. The segment leads away or is
// parallel to the path.
SweepQuery grazingQuery(SeededRandom& random, const Convex& shape) {
  SweepQuery query = randomQuery(random, shape);
  const Point left = perpendicular(query.displacement);
  const Point side = random.below(2) == 0 ? left : Point() - left;
  const auto part = static_cast<std::int64_t>(random.below(1024));
  const Point passed = query.position + farthest(shape, side) +
                       Point(static_cast<std::int32_t>(query.displacement.x * part / 1024),
                             static_cast<std::int32_t>(query.displacement.y * part / 1024));
  query.segment.a = passed + random.vector(2);
  query.segment.b = query.segment.a + (random.below(2) == 0 ? towards(random, side, 6 * kRadius) : query.displacement);
  return query;
}

// Straight at an end: across it, or so far that the foremost vertex reaches it within two subunits.
SweepQuery endPointQuery(SeededRandom& random, const Convex& shape) {
  SweepQuery query = randomQuery(random, shape);
  query.segment.a = query.position + query.displacement;
  if (random.below(3) != 0) query.segment.a += farthest(shape, query.displacement) + random.vector(2);
  query.segment.b = query.segment.a + towards(random, query.displacement, 2 * kRadius);
  return query;
}

// Segments of one length in random directions.
Make lineOf(std::int32_t length) {
  return [length](SeededRandom& random, const Convex&) {
    const Point half = rotate(Point((length + 1) / 2, 0), Angle(static_cast<std::int32_t>(random.below(Angle::kTurn))));
    const Point middle = random.vector(2 * kRadius);
    return SweepQuery{0, {}, random.vector(kSpeed), {middle - half, middle + half}};
  };
}

// A segment along an edge of the shape: the shape touches it at the start.
SweepQuery touchingQuery(SeededRandom& random, const Convex& shape) {
  const auto index = static_cast<std::size_t>(random.below(shape.vertices().size()));
  const Point vertex = shape.vertices()[index];
  const Point along = shape.vertices()[(index + 1) % shape.vertices().size()] - vertex;
  return {0, {}, random.vector(kSpeed), {vertex - along, vertex + along + along}};
}

bool isInRange(Point point) { return std::max(std::abs(point.x), std::abs(point.y)) < kCoordinateLimit; }

// Half of the displacements lead to the middle of the segment, if they are in range.
SweepQuery fullRangeQuery(SeededRandom& random, const Convex&) {
  const auto anywhere = [&] {
    const auto coordinate = [&] {
      return static_cast<std::int32_t>(static_cast<std::int64_t>(random.below(2 * kCoordinateLimit - 1)) -
                                       kCoordinateLimit + 1);
    };
    const std::int32_t x = coordinate();
    return Point(x, coordinate());
  };
  SweepQuery query{0, anywhere(), anywhere(), {}};
  query.segment.a = anywhere();
  query.segment.b = anywhere();
  const Point middle((query.segment.a.x + query.segment.b.x) / 2, (query.segment.a.y + query.segment.b.y) / 2);
  const Point there = middle - query.position;
  if (random.below(2) == 0 && isInRange(there)) query.displacement = there;
  return query;
}

// {x, y} with x * a.x + y * a.y = 1, for coprime coordinates (extended Euclidean algorithm).
Point bezout(Point a) {
  std::int64_t remainder[2] = {a.x, a.y};
  Point factors[2] = {{1, 0}, {0, 1}};
  while (remainder[1] != 0) {
    const auto quotient = static_cast<std::int32_t>(remainder[0] / remainder[1]);
    remainder[0] -= quotient * remainder[1];
    factors[0] = factors[0] - Point(quotient * factors[1].x, quotient * factors[1].y);
    std::swap(remainder[0], remainder[1]);
    std::swap(factors[0], factors[1]);
  }
  return remainder[0] > 0 ? factors[0] : Point() - factors[0];
}

// Vectors v almost parallel to `along`, which has coprime coordinates: cross(along, v) = `product`, and v is about
// `factor` times as long.
class Parallels {
 public:
  explicit Parallels(Point along) : along_(along) {
    const Point factors = bezout(along);  // cross(along, step) = 1
    step_ = {-factors.y, factors.x};
  }

  Point at(std::int64_t product, double factor) const {
    const auto x = static_cast<int128>(step_.x) * product;
    const auto y = static_cast<int128>(step_.y) * product;
    const auto wanted = static_cast<long double>(factor) * static_cast<long double>(along_.x);
    const auto times = static_cast<int128>((wanted - static_cast<long double>(x)) / static_cast<long double>(along_.x));
    return {static_cast<std::int32_t>(x + times * along_.x), static_cast<std::int32_t>(y + times * along_.y)};
  }

 private:
  Point along_;
  Point step_;
};

// The displacement and the segment have the largest length and are 1e-17 to 1e-13 rad off parallel. The nearest vertex
// starts less than one subunit beside the segment and ends on either side of it.
SweepQuery sliverQuery(SeededRandom& random, const Convex& shape) {
  for (;;) {
    const Point along = random.vector(kCoordinateLimit / 2);
    if (along.x == 0 || std::gcd(along.x, along.y) != 1) continue;
    const Parallels parallels(along);
    const std::uint64_t bits = random.below(12);
    const auto product = static_cast<std::int64_t>(1 + (random.below(1 << 12) >> bits));
    const double factor = 0.5 + static_cast<double>(random.below(1024)) / 2048;
    const Point vertex = farthest(shape, Point() - perpendicular(along));
    const Point a = random.vector(kCoordinateLimit - 1 - kCoordinateLimit / 2);
    const auto height = static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(product)) * 3 / 2);
    const Point position = a - vertex + parallels.at(height, static_cast<double>(random.below(1024)) / 4096);
    const SweepQuery query{0, position, parallels.at(-product, factor), {a, a + along}};
    if (isInRange(position) && isInRange(query.displacement) && isInRange(query.segment.b)) return query;
  }
}

}  // namespace

std::vector<SweepSet> sweepSets(std::size_t queries) {
  const MakeShapes huge = polygons(8, 1 << 14, 14);
  std::vector<SweepSet> sets{
      setOf("random", queries, &randomQuery),
      setOf("random-12-gon", queries, &randomQuery, polygons(12)),
      setOf("grazing", queries, &grazingQuery),
      setOf("end-point", queries, &endPointQuery),
      setOf("far-1e3", queries, farAway(1000 * 16384)),
      setOf("far-1e5", queries, farAway(100000 * kFarScale)),
      setOf("long-lines", queries, lineOf(10000 * 16384)),
      setOf("short-lines", queries, lineOf(8)),
      setOf("touching", queries, &touchingQuery),
      setOf("full-range", queries, &fullRangeQuery, huge),
      setOf("slivers", queries, &sliverQuery, huge),
  };
  for (SweepSet& set : sets) {
    if (set.name == "far-1e5") set.subunitsPerMetre = kFarScale;
  }
  return sets;
}

}  // namespace platon::bench
