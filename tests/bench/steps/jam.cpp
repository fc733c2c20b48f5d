#include "tests/bench/steps/jam.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "tests/bench/overlap.h"

namespace platon::bench {
namespace {

constexpr std::size_t kHalfSeconds = 8;
constexpr std::size_t kFewestRows = 256;  // half seconds of one body each
constexpr std::size_t kBodies = 64;

// Distance that counts: in a scene with gravity only the horizontal one.
double distanceOf(const Scene& scene, Place way) {
  return scene.gravity > 0 ? std::abs(way.x) : std::hypot(way.x, way.y);
}

Place between(Place from, Place to) { return {to.x - from.x, to.y - from.y}; }

Convex smaller(const Convex& shape) {
  std::vector<Point> vertices;
  const auto scaled = [](std::int32_t value) { return static_cast<std::int32_t>(std::lround(value * (1 - kSmaller))); };
  for (const Point vertex : shape.vertices()) vertices.emplace_back(scaled(vertex.x), scaled(vertex.y));
  return Convex(std::move(vertices));
}

// The segments that a body can reach from a place.
std::vector<Segment> near(const Scene& scene, Place place, Place velocity) {
  const Box& bounds = scene.shape.bounds();
  const double size = std::hypot(bounds.high.x - bounds.low.x, bounds.high.y - bounds.low.y);
  const double fall = scene.gravity * kStepsOfOneVelocity * kStepsOfOneVelocity;
  const double reach = std::hypot(velocity.x, velocity.y) * kStepsOfOneVelocity + fall + size;
  const auto isFar = [reach](double low, double high, double at) {
    return std::max(low, high) < at - reach || std::min(low, high) > at + reach;
  };
  std::vector<Segment> found;
  for (const Segment& line : scene.segments) {
    if (!isFar(line.a.x, line.b.x, place.x) && !isFar(line.a.y, line.b.y, place.y)) found.push_back(line);
  }
  return found;
}

std::size_t removeOverlapped(std::vector<Segment>& lines, const Convex& shape, Point at) {
  return std::erase_if(lines, [&](const Segment& line) { return overlapOf(shape, at.x, at.y, line) > 0; });
}

// The lattice points around a place.
std::vector<Point> roundings(Place place) {
  const auto x = static_cast<std::int32_t>(std::floor(place.x));
  const auto y = static_cast<std::int32_t>(std::floor(place.y));
  return {{x, y}, {x + 1, y}, {x, y + 1}, {x + 1, y + 1}};
}

// Whether float64 moves on in this scene of one body.
bool movesOn(const Scene& scene, Place velocity) {
  const auto ideal = makeFloat64(scene);
  const Place start = ideal->position(0);
  for (int step = 0; step < kStepsOfOneVelocity; ++step) {
    ideal->setVelocity(0, velocity);
    ideal->step();
  }
  const double wanted = distanceOf(scene, velocity) * kStepsOfOneVelocity;
  return distanceOf(scene, between(start, ideal->position(0))) > kFree * wanted;
}

bool idealMovesOn(const Scene& scene, Place place, Place velocity) {
  Scene around{.segments = near(scene, place, velocity),
               .shape = scene.shape,
               .bodies = {},
               .subunitsPerUnit = scene.subunitsPerUnit,
               .gravity = scene.gravity};
  for (const Point start : roundings(place)) {
    std::vector<Segment> lines = around.segments;
    if (removeOverlapped(lines, scene.shape, start) > 0) continue;
    around.bodies = {start};
    if (!movesOn(around, velocity)) return false;
    break;
  }
  around.shape = smaller(scene.shape);
  around.bodies = {roundings(place).front()};
  removeOverlapped(around.segments, around.shape, around.bodies[0]);
  return movesOn(around, velocity);
}

}  // namespace

Jams countJams(StepRunner& runner, const Scene& scene) {
  const std::size_t bodies = std::min(scene.bodies.size(), kBodies);
  Jams jams;
  const std::size_t halfSeconds = std::max(kHalfSeconds, kFewestRows / bodies);
  for (std::size_t half = 0; half < halfSeconds; ++half) {
    std::vector<Place> starts;
    for (std::size_t i = 0; i < bodies; ++i) starts.push_back(runner.engine().position(i));
    runner.runOneVelocity();
    for (std::size_t i = 0; i < bodies; ++i) {
      const Place velocity = runner.velocity(i);
      const double wanted = distanceOf(scene, velocity) * kStepsOfOneVelocity;
      if (wanted == 0) continue;
      ++jams.halfSeconds;
      const double moved = distanceOf(scene, between(starts[i], runner.engine().position(i)));
      if (moved < kJammed * wanted && idealMovesOn(scene, starts[i], velocity)) ++jams.jammed;
    }
  }
  return jams;
}

}  // namespace platon::bench
