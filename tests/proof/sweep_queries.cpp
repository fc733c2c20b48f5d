// platon-sweep-queries COUNT SEED QUERIES ANSWERS
// Writes queries for proved_sweep.ml, and what the C++ answers by every route that a step takes. All routes must agree.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "platon/exact/integer.h"
#include "platon/physics/convex.h"
#include "platon/physics/map_geometry.h"
#include "platon/physics/obstacle.h"
#include "platon/physics/segment.h"
#include "platon/physics/sweep.h"
#include "shared/physics/region.h"
#include "shared/physics/tolerances.h"
#include "tests/shared/physics/shapes.h"
#include "tests/sim/seeded_random.h"

namespace {

using namespace platon;

using Answer = std::optional<Hit>;

bool isSame(const Answer& a, const Answer& b) {
  if (!a || !b) return !a && !b;
  return a->time == b->time && a->exit == b->exit && a->normal == b->normal && a->feature == b->feature &&
         a->side == b->side;
}

// Now and then a shape with more edges than Obstacle has groups of them; on a fine lattice, or they would be collinear.
Convex drawShape(sim::SeededRandom& random, std::int32_t reach) {
  constexpr std::int32_t kFine = 50000;
  if (reach < kFine || random.below(8) != 0) return randomConvex(random, reach);
  return regular(random.below(2) == 0 ? 72 : 144, reach);
}

struct Query {
  Point position;
  Point displacement;
  std::int32_t margin;
};

// A shape and a segment, with the queries about them. Coordinates are up to `reach`: the smaller it is, the more of
// them touch, are parallel or meet corners.
class Scene {
 public:
  Scene(sim::SeededRandom& random, std::int32_t reach)
      : random_(random), reach_(reach), shape_(drawShape(random, reach)), segment_{random.vector(reach), {}} {
    segment_.b = random.below(8) == 0 ? segment_.a : random.vector(reach);
    obstacle_.build(shape_, segment_);
    part_.segments = {segment_};
    part_.grid = Grid(part_.segments);
  }

  Query draw() {
    Query query{random_.vector(2 * reach_), {}, 0};
    query.displacement = random_.vector(2 * reach_) - query.position;
    if (random_.below(8) == 0) query.displacement = {};
    if (random_.below(4) == 0) query.displacement = random_.below(2) == 0 ? alongSegment() : alongEdge();
    if (random_.below(4) == 0) query.position = touching();
    if (random_.below(4) == 0) query.margin = Tolerances::kNear;
    return query;
  }
  // Whether the query is one that a sweep may be asked.
  bool mayAsk(const Query& query) {
    const Point end = query.position + query.displacement;
    if (!isCoordinate(end.x) || !isCoordinate(end.y) || !isCoordinate(query.position.x) ||
        !isCoordinate(query.position.y))
      return false;
    sweep_.start(shape_, query.position, query.displacement, query.margin);
    return query.margin == 0 || !sweep_.misses(boundsOf(segment_));
  }
  // Ends the program where two routes differ.
  Answer answer(const Query& query) {
    sweep_.start(shape_, query.position, query.displacement, query.margin);
    const Answer first = sweep_.against(segment_);
    require(isSame(first, throughRegion(query)), "a region", query);
    if (sweep_.misses(boundsOf(segment_))) return first;
    Obstacle fresh;
    fresh.build(shape_, segment_);
    require(isSame(first, sweep_.against(fresh)), "an obstacle", query);
    require(isSame(first, hit(sweep_.clip(obstacle_))), "an obstacle that was used before", query);
    Obstacle::HalfPlane separating{};
    const auto interval = sweep_.clip(segment_, separating);
    require(isSame(first, interval ? Answer(Sweep::hitOf(shape_, segment_, *interval)) : std::nullopt), "a segment",
            query);
    require(separating.normal == Point() || (!first && sweep_.isExcluded(separating)), "a cached half plane", query);
    return first;
  }
  std::string text(const Query& query) const {
    std::string line = std::to_string(query.margin);
    const auto add = [&](Point point) { line += " " + std::to_string(point.x) + " " + std::to_string(point.y); };
    for (const Point point : {query.position, query.displacement, segment_.a, segment_.b}) add(point);
    line += " " + std::to_string(shape_.vertices().size());
    for (const Point vertex : shape_.vertices()) add(vertex);
    return line;
  }

 private:
  Point vertex() { return shape_.vertices()[random_.below(shape_.vertices().size())]; }
  // A position at which a vertex of the shape is on an end of the segment, or beside it.
  Point touching() { return (random_.below(2) == 0 ? segment_.a : segment_.b) - vertex(); }
  Point alongSegment() { return segment_.b - segment_.a; }
  Point alongEdge() {
    const Point first = vertex();
    return vertex() - first;
  }
  // As the step asks: what earlier queries have left in the region may answer.
  Answer throughRegion(const Query& query) {
    constexpr Box kEverything{{-kCoordinateLimit, -kCoordinateLimit}, {kCoordinateLimit, kCoordinateLimit}};
    // With a margin, a corner of the obstacle may be met outside of the bounds of the sweep.
    region_.cover(part_, query.margin == 0 ? sweep_.bounds() : kEverything, work_);
    const auto entry = region_.entryOf(0);
    if (!entry) return std::nullopt;
    const bool mayOverlap = random_.below(2) == 0 || region_.mayOverlap(sweep_, *entry, shape_);
    const auto interval = region_.clip(sweep_, *entry, shape_);
    require(!interval || (mayOverlap && region_.mayOverlap(sweep_, *entry, shape_)), "a region that may be left out",
            query);
    return interval ? Answer(region_.hitOf(*entry, *interval)) : std::nullopt;
  }
  Answer hit(const std::optional<Sweep::ClipInterval>& interval) const {
    return interval ? Answer(Sweep::hitOf(obstacle_, *interval)) : std::nullopt;
  }
  void require(bool agrees, const char* route, const Query& query) const {
    if (agrees) return;
    std::fprintf(stderr, "platon-sweep-queries: %s answers otherwise: %s\n", route, text(query).c_str());
    std::exit(1);
  }

  sim::SeededRandom& random_;
  std::int32_t reach_;
  Convex shape_;
  Segment segment_;
  Obstacle obstacle_;
  MapGeometry part_{};
  Region region_;
  Region::Work work_;
  Sweep sweep_;
};

std::string text(const Answer& answer) {
  if (!answer) return "miss";
  std::string line;
  for (const Fraction& time : {answer->time, answer->exit})
    line += std::to_string(time.numerator) + " " + std::to_string(time.denominator) + " ";
  line += std::to_string(static_cast<int>(answer->side));
  for (const Point point : {answer->normal, answer->feature})
    line += " " + std::to_string(point.x) + " " + std::to_string(point.y);
  return line;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) return std::fprintf(stderr, "usage: platon-sweep-queries COUNT SEED QUERIES ANSWERS\n"), 2;
  constexpr std::int32_t kReaches[] = {2, 4, 20, 1000, 50000, 1 << 27, (1 << 28) - 1};
  constexpr int kQueriesOfAScene = 8;
  sim::SeededRandom random(std::strtoull(argv[2], nullptr, 10));
  std::ofstream queries(argv[3]);
  std::ofstream answers(argv[4]);
  std::uint64_t left = std::strtoull(argv[1], nullptr, 10);
  for (std::size_t round = 0; left > 0; ++round) {
    Scene scene(random, kReaches[round % std::size(kReaches)]);
    for (int i = 0; i < kQueriesOfAScene && left > 0; ++i) {
      const Query query = scene.draw();
      if (!scene.mayAsk(query)) continue;
      queries << scene.text(query) << '\n';
      answers << text(scene.answer(query)) << '\n';
      --left;
    }
  }
  return queries && answers ? 0 : 1;
}
