// Floors of separate segments in any order and at any slope, with ends that are slightly off (I3).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "platon/exact/angle.h"
#include "platon/exact/integer.h"
#include "platon/game/player.h"
#include "platon/physics/convex.h"
#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "platon/physics/world.h"
#include "tests/exactness/hard_cases/checked_world.h"
#include "tests/exactness/step_check/run_length.h"
#include "tests/shared/game/real_face.h"
#include "tests/shared/physics/maps.h"
#include "tests/sim/seeded_random.h"
#include "tests/support/run/repetitions.h"

namespace platon::hard_cases::joints_test {
namespace {

/// Bounds of every step along a floor.
struct Bounds {
  double minShare;   ///< least part of the ideal progress
  double tolerance;  ///< subunits below that part
  double maxHeight;  ///< subunits above the ideal floor
};

/// What a step may lose at the ends of a joint that are up to `apart` subunits apart: the ideal body slides over an end
/// with at least 1/32 of its speed, or it is nudged past. The lattice is up to 2 subunits from the ideal body.
constexpr double lossAt(double apart) { return 32 * apart + 2 * 2; }

/// For ends off by 1 subunit along each axis: they are up to 1.42 above the floor, and I3 allows 3 more.
constexpr Bounds kNearlyCollinear = {0.99, lossAt(2 * 1.42), 1.42 + 3};
/// For ends off by 2 subunits along each axis, which is more than I3 covers.
constexpr Bounds kCoarse = {0.97, lossAt(4 * 1.42), 2 * 1.42 + 3};

/// Largest part of the downward motion, in subunits, that a nudge and roundings may stop without a contact.
constexpr double kMaxNudge = 8;

constexpr double kMargin = 40000;  // floor before the start and after the end; longer than any shape

class FloorRandom : public sim::SeededRandom {
 public:
  using SeededRandom::SeededRandom;

  /// A number between low and high; its logarithm is uniformly distributed.
  double between(double low, double high) {
    constexpr std::uint64_t steps = 1 << 20;
    return low * std::pow(high / low, static_cast<double>(below(steps)) / steps);
  }
  std::int32_t whole(std::int32_t low, std::int32_t high) {
    return low + static_cast<std::int32_t>(below(static_cast<std::uint64_t>(high - low) + 1));
  }
};

/// The ideal floor: a line through the origin. The entity is above it.
struct Floor {
  Real along;

  Real up() const { return left(along); }
  double progress(Point position) const { return dot(real(position), along); }
  double height(Point position) const { return dot(real(position), up()); }
  double lowest(const Convex& shape) const {
    double least = HUGE_VAL;
    for (const Point vertex : shape.vertices()) least = std::min(least, height(vertex));
    return least;
  }
};

/// A floor of segments and an entity on it.
struct Chain {
  Floor floor;
  Convex shape;
  std::vector<Segment> lines;
  Point start;
  Point velocity;
  int ticks = 0;
};

Angle slopeFrom(FloorRandom& random) {
  return random.below(4) == 0 ? Angle::degrees(45 * random.whole(0, 7)) : Angle(random.whole(0, Angle::kTurn - 1));
}

/// True if the lowest vertex is sharper than 30 degrees: the gap at a joint may stop such a vertex.
bool standsOnATip(const Convex& shape, const Floor& floor) {
  const auto& vertices = shape.vertices();
  const auto lower = [&](Point a, Point b) { return floor.height(a) < floor.height(b); };
  const auto least = std::min_element(vertices.begin(), vertices.end(), lower);
  const auto lowest = static_cast<std::size_t>(least - vertices.begin());
  const Real ahead = real(vertices[(lowest + 1) % vertices.size()] - vertices[lowest]);
  const Real behind = real(vertices[(lowest + vertices.size() - 1) % vertices.size()] - vertices[lowest]);
  return dot(ahead, behind) > std::cos(std::numbers::pi / 6) * length(ahead) * length(behind);
}

/// A polygon of 3 to 20 points on a circle, without a sharp lowest vertex.
Convex polygonFrom(FloorRandom& random, const Floor& floor) {
  for (;;) {
    const double radius = random.between(100, 12000);
    std::vector<Point> vertices;
    for (std::int32_t left = random.whole(3, 20); left > 0; --left) {
      vertices.push_back(nearest(turned({radius, 0}, Angle(random.whole(0, Angle::kTurn - 1)))));
    }
    auto hull = convexHull(vertices);
    if (Convex::fault(hull)) continue;
    Convex shape(std::move(hull));
    if (!standsOnATip(shape, floor)) return shape;
  }
}

Convex shapeFrom(FloorRandom& random, const Floor& floor) {
  const std::uint64_t kind = random.below(4);
  if (kind == 0) return playerShape();
  if (kind != 1) return polygonFrom(random, floor);
  const std::int32_t x = random.whole(200, 12000);
  const std::int32_t y = random.whole(200, 12000);
  return Convex(std::vector<Point>{{-x, -y}, {x, -y}, {x, y}, {-x, y}});
}

/// Segments along the floor, with every end off by up to `off` along each axis. One in four overlaps the one before.
std::vector<Segment> linesFrom(FloorRandom& random, const Floor& floor, double shortest, double length,
                               std::int32_t off) {
  std::vector<Segment> lines;
  const auto end = [&](double at) {
    return nearest(at * floor.along) + Point(random.whole(-off, off), random.whole(-off, off));
  };
  for (double at = -kMargin; at < length + kMargin;) {
    const double overlap = random.below(4) == 0 ? random.between(1, shortest) : 0;
    const Point first = end(at - overlap);
    at += random.between(shortest, std::min(10 * shortest, 40000.0));
    lines.push_back({first, end(at)});
    if (random.below(2) == 0) std::swap(lines.back().a, lines.back().b);
  }
  for (std::size_t left = lines.size(); left > 1; --left) std::swap(lines[left - 1], lines[random.below(left)]);
  return lines;
}

Chain chainFrom(std::uint64_t seed, std::int32_t off) {
  FloorRandom random(seed);
  const Floor floor{turned({1, 0}, slopeFrom(random))};
  const double shortest = random.between(300, 16000);
  const double speed = random.between(64, std::min(8000.0, shortest / 2));
  const double press = random.between(10, speed);
  const double length = std::min(400 * speed, 400000.0);
  Chain chain{floor, shapeFrom(random, floor), linesFrom(random, floor, shortest, length, off), {}, {}, 0};
  chain.start = nearest((8 - floor.lowest(chain.shape)) * floor.up());
  chain.velocity = nearest(speed * floor.along - press * floor.up());
  chain.ticks = static_cast<int>(length / speed);
  return chain;
}

World worldOf(const Chain& chain) {
  World world;
  addPart(world, 0, chain.lines);
  Entity entity(world, chain.shape);
  MapPart(world, 0).insert(entity, chain.start, Angle());
  return world;
}

/// The worst values of all steps.
struct WorstValues {
  std::int64_t steps = 0;
  double loss = -HUGE_VAL;    ///< subunits below the required part of the ideal progress
  double height = -HUGE_VAL;  ///< subunits above the ideal floor

  void print() const {
    std::cout << steps << " steps; progress at most " << loss << " subunits below its bound, height at most " << height
              << " subunits above the floor\n";
  }
};

/// Moves along the floor and expects that every step keeps within the bounds.
void expectWithinBounds(CheckedWorld& scene, const Floor& floor, Point velocity, int ticks, const Bounds& bounds,
                        WorstValues& worst) {
  const double ideal = floor.progress(velocity);
  const double lowest = floor.lowest(scene.shape);
  const Point down = nearest(-60 * floor.up());
  for (int tick = 0; tick < 5; ++tick) scene.tick(down);
  for (int tick = 0; tick < ticks; ++tick) {
    const Point before = scene.at();
    SCOPED_TRACE("tick " + std::to_string(tick) + ", from " + testing::PrintToString(before));
    scene.tick(velocity);
    const double progress = floor.progress(scene.at() - before);
    const double height = floor.height(scene.at()) + lowest;
    const double stopped = floor.height(scene.at() - before) - floor.height(velocity);
    worst.loss = std::max(worst.loss, bounds.minShare * ideal - progress);
    worst.height = std::max(worst.height, height);
    ++worst.steps;
    ASSERT_GE(progress, bounds.minShare * ideal - bounds.tolerance);
    ASSERT_LE(height, bounds.maxHeight);
    ASSERT_TRUE(stopped <= kMaxNudge || !scene.rules.contacts.empty()) << "stopped without a contact";
    ASSERT_TRUE(scene.invariantsHold());
  }
}

void expectChainWithinBounds(std::uint64_t seed, std::int32_t off, const Bounds& bounds, WorstValues& worst) {
  const std::string name = "seed " + std::to_string(seed) + ", ends off by " + std::to_string(off);
  SCOPED_TRACE(name);
  const Chain chain = chainFrom(seed, off);
  CheckedWorld scene(name, worldOf(chain), {.shape = chain.shape});
  expectWithinBounds(scene, chain.floor, chain.velocity, chain.ticks, bounds, worst);
}

void expectChainsWithinBounds(std::int64_t chains, std::int32_t off, const Bounds& bounds) {
  WorstValues worst;
  const auto count = static_cast<std::uint64_t>(step_check::runLength(chains, 100 * chains));
  for (std::uint64_t seed = 0; seed < count && !testing::Test::HasFailure(); ++seed) {
    expectChainWithinBounds(seed, off, bounds, worst);
  }
  worst.print();
  EXPECT_GE(worst.steps, 370 * repetitions(chains));
}

TEST(JointsTest, EndsOffByOneSubunitDoNotStopTheEntity) { expectChainsWithinBounds(1600, 1, kNearlyCollinear); }

TEST(JointsTest, EndsOffByTwoSubunitsDoNotStopTheEntity) { expectChainsWithinBounds(800, 2, kCoarse); }

/// A chain in a scene file, and its parameters.
struct ChainFile {
  const char* name;
  Angle slope;
  std::int32_t off;
  int ticks;
};

const ChainFile kChainFiles[] = {
    {"level", Angle(), 1, 98},
    {"diagonal", Angle(-4500), 1, 255},
    {"slanted", Angle(1114), 1, 134},
    {"rough", Angle(-933), 2, 264},
};

TEST(JointsTest, ChainsInSceneFilesStayWithinBounds) {
  for (const ChainFile& file : kChainFiles) {
    SCOPED_TRACE(file.name);
    HardScene scene(std::string("joints/") + file.name + ".scene");
    const Floor floor{turned({1, 0}, file.slope)};
    for (const Segment& line : scene.world.geometry().parts[0]->segments) {
      ASSERT_LE(std::abs(floor.height(line.a)), (file.off + 0.5) * std::numbers::sqrt2);
      ASSERT_LE(std::abs(floor.height(line.b)), (file.off + 0.5) * std::numbers::sqrt2);
    }
    WorstValues worst;
    expectWithinBounds(scene, floor, scene.velocity, file.ticks, file.off == 1 ? kNearlyCollinear : kCoarse, worst);
  }
}

}  // namespace
}  // namespace platon::hard_cases::joints_test
