// platon-sweep-queries COUNT SEED QUERIES ANSWERS
// Writes queries for proved_sweep.ml, and what the C++ answers: sweeps by every route that a step takes, which must all
// agree, whether shapes are valid, and where instances are.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "platon/exact/integer.h"
#include "platon/physics/convex.h"
#include "platon/physics/map_geometry.h"
#include "platon/physics/obstacle.h"
#include "platon/physics/segment.h"
#include "platon/physics/sweep.h"
#include "shared/physics/instances.h"
#include "shared/physics/region.h"
#include "shared/physics/tolerances.h"
#include "tests/shared/physics/shapes.h"
#include "tests/sim/seeded_random.h"

namespace {

using namespace platon;

using Answer = std::optional<Hit>;

constexpr std::int32_t kMax = kCoordinateLimit - 1;

bool isSame(const Answer& a, const Answer& b) {
  if (!a || !b) return !a && !b;
  return a->time == b->time && a->exit == b->exit && a->normal == b->normal && a->feature == b->feature &&
         a->side == b->side;
}

bool isInRange(Point point) { return isCoordinate(point.x) && isCoordinate(point.y); }

std::string text(std::span<const Point> points) {
  std::string line;
  for (const Point point : points) line += " " + std::to_string(point.x) + " " + std::to_string(point.y);
  return line;
}

// Up to `reach`; with kMax, often at the limit.
Point drawPoint(sim::SeededRandom& random, std::int32_t reach) {
  if (reach != kMax) return random.vector(reach);
  const auto coordinate = [&] {
    if (random.below(4) == 0) return random.below(2) == 0 ? kMax : -kMax;
    return static_cast<std::int32_t>(static_cast<std::int64_t>(random.below(2 * std::uint64_t{kMax} + 1)) - kMax);
  };
  const std::int32_t x = coordinate();
  return {x, coordinate()};
}

// Now and then a shape with more edges than Obstacle has groups of them; on a fine lattice, or they would be collinear.
Convex drawShape(sim::SeededRandom& random, std::int32_t reach) {
  constexpr std::int32_t kFine = 50000;
  if (reach >= kFine && random.below(8) == 0) return regular(random.below(2) == 0 ? 72 : 144, std::min(reach, 1 << 28));
  for (;;) {
    std::vector<Point> points(3 + random.below(10));
    for (Point& point : points) point = drawPoint(random, reach);
    auto hull = convexHull(std::move(points));
    if (!Convex::fault(hull)) return Convex(std::move(hull));
  }
}

Segment drawSegment(sim::SeededRandom& random, std::int32_t reach) {
  const Point a = drawPoint(random, reach);
  return {a, random.below(8) == 0 ? a : drawPoint(random, reach)};
}

struct Query {
  std::size_t shape;
  std::size_t segment;
  Point position;
  Point displacement;
  std::int32_t margin;
};

// Two shapes and two segments, with the queries about them. Coordinates are up to `reach`: the smaller it is, the more
// of them touch, are parallel or meet corners.
class Scene {
 public:
  Scene(sim::SeededRandom& random, std::int32_t reach)
      : random_(random), reach_(reach), shapes_{drawShape(random, reach), drawShape(random, reach)} {
    part_.segments = {drawSegment(random, reach), drawSegment(random, reach)};
    part_.grid = Grid(part_.segments);
    for (std::size_t shape = 0; shape < 2; ++shape) {
      for (std::size_t segment = 0; segment < 2; ++segment)
        obstacles_[shape][segment].build(shapes_[shape], part_.segments[segment]);
    }
  }

  Query draw() {
    constexpr std::int32_t kMargins[] = {Tolerances::kInsert, Tolerances::kDrop, Tolerances::kNear};
    const std::int32_t far = reach_ == kMax ? kMax : 2 * reach_;
    Query query{random_.below(4) == 0, random_.below(2), drawPoint(random_, far), {}, 0};
    query.displacement = drawPoint(random_, far) - query.position;
    if (random_.below(8) == 0) query.displacement = {};
    if (random_.below(4) == 0) query.displacement = random_.below(2) == 0 ? alongSegment(query) : alongEdge(query);
    if (random_.below(4) == 0) query.position = touching(query);
    if (random_.below(3) == 0) query.margin = kMargins[random_.below(3)];
    return query;
  }
  // Whether the query is one that a sweep may be asked.
  static bool mayAsk(const Query& query) {
    return isInRange(query.position) && isInRange(query.position + query.displacement);
  }
  // Nothing when the bounds of the sweep miss the segment. Ends the program where two routes differ.
  std::optional<Answer> answer(const Query& query) {
    const Convex& shape = shapes_[query.shape];
    const Segment& segment = part_.segments[query.segment];
    sweep_.start(shape, query.position, query.displacement, query.margin);
    const Answer first = sweep_.against(segment);
    require(isSame(first, throughRegion(query)), "a region", query);
    if (sweep_.misses(boundsOf(segment))) return std::nullopt;
    Obstacle fresh;
    fresh.build(shape, segment);
    require(isSame(first, sweep_.against(fresh)), "an obstacle", query);
    Obstacle& used = obstacles_[query.shape][query.segment];
    const auto again = sweep_.clip(used);
    require(isSame(first, again ? Answer(Sweep::hitOf(used, *again)) : std::nullopt),
            "an obstacle that was used before", query);
    Obstacle::HalfPlane separating{};
    const auto interval = sweep_.clip(segment, separating);
    require(isSame(first, interval ? Answer(Sweep::hitOf(shape, segment, *interval)) : std::nullopt), "a segment",
            query);
    require(separating.normal == Point() || (!first && sweep_.isExcluded(separating)), "a cached half plane", query);
    return first;
  }
  std::string text(const Query& query) const {
    const Segment& segment = part_.segments[query.segment];
    const std::array<Point, 4> points{query.position, query.displacement, segment.a, segment.b};
    return "sweep " + std::to_string(query.margin) + ::text(points) + ::text(shapes_[query.shape].vertices());
  }

 private:
  Point vertex(const Query& query) { return vertexOf(shapes_[query.shape]); }
  Point vertexOf(const Convex& shape) { return shape.vertices()[random_.below(shape.vertices().size())]; }
  // A position at which a vertex of the shape is on an end of the segment, or beside it.
  Point touching(const Query& query) {
    const Segment& segment = part_.segments[query.segment];
    return (random_.below(2) == 0 ? segment.a : segment.b) - vertex(query);
  }
  Point alongSegment(const Query& query) const {
    return part_.segments[query.segment].b - part_.segments[query.segment].a;
  }
  Point alongEdge(const Query& query) {
    const Point first = vertex(query);
    return vertex(query) - first;
  }
  // As the step asks: what earlier queries have left in the region may answer.
  Answer throughRegion(const Query& query) {
    constexpr Box kEverything{{-kCoordinateLimit, -kCoordinateLimit}, {kCoordinateLimit, kCoordinateLimit}};
    const Convex& shape = shapes_[query.shape];
    // With a margin, a corner of the obstacle may be met outside of the bounds of the sweep.
    region_.cover(part_, query.margin == 0 ? sweep_.bounds() : kEverything, work_);
    const bool asksFirst = random_.below(2) == 0;
    const auto entry = region_.entryOf(static_cast<std::uint32_t>(query.segment));
    if (!entry) return std::nullopt;
    const bool mayOverlap = !asksFirst || region_.mayOverlap(sweep_, *entry, shape);
    const auto interval = region_.clip(sweep_, *entry, shape);
    require(!interval || (mayOverlap && region_.mayOverlap(sweep_, *entry, shape)), "a region that may be left out",
            query);
    return interval ? Answer(region_.hitOf(*entry, *interval)) : std::nullopt;
  }
  void require(bool agrees, const char* route, const Query& query) const {
    if (agrees) return;
    std::fprintf(stderr, "platon-sweep-queries: %s answers otherwise: %s\n", route, text(query).c_str());
    std::exit(1);
  }

  sim::SeededRandom& random_;
  std::int32_t reach_;
  std::array<Convex, 2> shapes_;
  std::array<std::array<Obstacle, 2>, 2> obstacles_;  // by shape and segment
  MapGeometry part_{};
  Region region_;
  Region::Work work_;
  Sweep sweep_;
};

std::string text(const std::optional<Answer>& answer) {
  if (!answer) return "far";
  if (!*answer) return "miss";
  const Hit& hit = **answer;
  std::string line;
  for (const Fraction& time : {hit.time, hit.exit})
    line += std::to_string(time.numerator) + " " + std::to_string(time.denominator) + " ";
  return line + std::to_string(static_cast<int>(hit.side)) + text(std::array{hit.normal, hit.feature});
}

// A shape of which some vertices are moved, exchanged or repeated.
std::vector<Point> drawVertices(sim::SeededRandom& random, std::int32_t reach) {
  std::vector<Point> vertices = drawShape(random, reach).vertices();
  const auto any = [&]() -> Point& { return vertices[random.below(vertices.size())]; };
  switch (random.below(6)) {
    case 0:
      any() = drawPoint(random, reach);
      break;
    case 1:
      std::swap(any(), any());
      break;
    case 2:
      vertices.insert(vertices.end(), vertices.begin(), vertices.end());  // winds twice
      break;
    case 3:
      any() += {static_cast<std::int32_t>(random.below(3)) - 1, 1};  // perhaps out of range
      break;
    case 4:
      vertices.resize(random.below(4));
      break;
    default:
      break;
  }
  return vertices;
}

struct Place {
  Rotation rotation;
  std::array<Point, 3> points;  // anchor at home, anchor, home
};

Place drawPlace(sim::SeededRandom& random, std::int32_t reach) {
  const Rotation rotation = rotationOf(Angle(static_cast<std::int32_t>(random.below(Angle::kTurn))));
  const Point homeAnchor = drawPoint(random, reach);
  const Point anchor = drawPoint(random, reach);
  return {random.below(8) == 0 ? Rotation::none() : rotation, {homeAnchor, anchor, drawPoint(random, reach)}};
}

Point positionAt(const Place& place) {
  Placement placement;
  placement.fromHome = place.rotation;
  placement.homeAnchor = place.points[0];
  placement.anchor = place.points[1];
  return placement.at(place.points[2]);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) return std::fprintf(stderr, "usage: platon-sweep-queries COUNT SEED QUERIES ANSWERS\n"), 2;
  constexpr std::int32_t kReaches[] = {2, 4, 20, 1000, 50000, (1 << 27) - 1, kMax};
  constexpr int kSweepsOfAScene = 16;
  sim::SeededRandom random(std::strtoull(argv[2], nullptr, 10));
  std::ofstream queries(argv[3]);
  std::ofstream answers(argv[4]);
  std::uint64_t left = std::strtoull(argv[1], nullptr, 10);
  const auto ask = [&](const std::string& query, const std::string& answer) {
    if (left == 0) return;
    --left;
    queries << query << '\n';
    answers << answer << '\n';
  };
  for (std::size_t round = 0; left > 0; ++round) {
    const std::int32_t reach = kReaches[round % std::size(kReaches)];
    Scene scene(random, reach);
    for (int i = 0; i < kSweepsOfAScene; ++i) {
      const Query query = scene.draw();
      if (Scene::mayAsk(query)) ask(scene.text(query), text(scene.answer(query)));
    }
    const std::vector<Point> vertices = drawVertices(random, reach);
    ask("shape" + text(vertices), Convex::fault(vertices) ? "refused" : "valid");
    const Place place = drawPlace(random, reach);
    ask("place " + std::to_string(place.rotation.cosine) + " " + std::to_string(place.rotation.sine) +
            text(place.points),
        "at" + text(std::array{positionAt(place)}));
  }
  return queries && answers ? 0 : 1;
}
