// Floors of loose segments: any order, any slope, no connectivity, ends that are a little off (I3).
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
#include "tests/exactness/hard_cases/judged_world.h"
#include "tests/exactness/judge/run_length.h"
#include "tests/shared/game/real_face.h"
#include "tests/sim/seeded_random.h"

namespace platon::hard_cases {
namespace {

/// What is asked of every step along a floor.
struct Promise {
  double share;  ///< of the ideal progress
  double slack;  ///< subunits less: each of the few legs of a step is cut to whole subunits
  double lift;   ///< subunits above the ideal floor
};

/// Both ends of a joint may be off by 1 subunit in each axis: one is then 1.42 above the floor, and I3 leaves 3 more.
constexpr Promise kNearlyCollinear = {0.99, 4, 1.42 + 3};
/// Off by 2 in each axis, more than I3 speaks of.
constexpr Promise kCoarse = {0.97, 6, 2 * 1.42 + 3};

/// What a nudge may take of a press without a contact, and a rounding or two more.
constexpr double kUntold = 8;

constexpr double kRunUp = 40000;  // of floor before the start and behind the end, more than any shape is long

class Numbers : public sim::SeededRandom {
 public:
  using SeededRandom::SeededRandom;

  /// From low to high, every order of magnitude as often as another.
  double between(double low, double high) {
    constexpr std::uint64_t steps = 1 << 20;
    return low * std::pow(high / low, static_cast<double>(below(steps)) / steps);
  }
  std::int32_t whole(std::int32_t low, std::int32_t high) {
    return low + static_cast<std::int32_t>(below(static_cast<std::uint64_t>(high - low) + 1));
  }
};

/// The ideal floor goes through the origin; the mover is above it.
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

/// A floor of segments with a mover on it.
struct Chain {
  Floor floor;
  Convex shape;
  std::vector<Segment> lines;
  Point start;
  Point velocity;
  int ticks = 0;
};

Angle slopeFrom(Numbers& random) {
  return random.below(4) == 0 ? Angle::degrees(45 * random.whole(0, 7)) : Angle(random.whole(0, Angle::kTurn - 1));
}

/// Whether the lowest corner is a needle's tip, sharper than 30 degrees: the gap of a joint may be a hole for it.
bool standsOnATip(const Convex& shape, const Floor& floor) {
  const auto& corners = shape.vertices();
  const auto lower = [&](Point a, Point b) { return floor.height(a) < floor.height(b); };
  const auto least = std::min_element(corners.begin(), corners.end(), lower);
  const auto lowest = static_cast<std::size_t>(least - corners.begin());
  const Real ahead = real(corners[(lowest + 1) % corners.size()] - corners[lowest]);
  const Real behind = real(corners[(lowest + corners.size() - 1) % corners.size()] - corners[lowest]);
  return dot(ahead, behind) > std::cos(std::numbers::pi / 6) * length(ahead) * length(behind);
}

/// 3 to 20 corners on a circle; another one where these are on one line.
Convex polygonFrom(Numbers& random, const Floor& floor) {
  for (;;) {
    const double radius = random.between(100, 12000);
    std::vector<Point> corners;
    for (std::int32_t left = random.whole(3, 20); left > 0; --left) {
      corners.push_back(nearest(turned({radius, 0}, Angle(random.whole(0, Angle::kTurn - 1)))));
    }
    auto hull = convexHull(corners);
    if (Convex::fault(hull)) continue;
    Convex shape(std::move(hull));
    if (!standsOnATip(shape, floor)) return shape;
  }
}

Convex shapeFrom(Numbers& random, const Floor& floor) {
  const std::uint64_t kind = random.below(4);
  if (kind == 0) return playerShape();
  if (kind != 1) return polygonFrom(random, floor);
  const std::int32_t x = random.whole(200, 12000);
  const std::int32_t y = random.whole(200, 12000);
  return Convex(std::vector<Point>{{-x, -y}, {x, -y}, {x, y}, {-x, y}});
}

/// From end to end, with every end off by up to `off` in each axis, one in four beginning before the last one's end.
std::vector<Segment> linesFrom(Numbers& random, const Floor& floor, double shortest, double length, std::int32_t off) {
  std::vector<Segment> lines;
  const auto end = [&](double at) {
    return nearest(at * floor.along) + Point(random.whole(-off, off), random.whole(-off, off));
  };
  for (double at = -kRunUp; at < length + kRunUp;) {
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
  Numbers random(seed);
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
  MapPart part(world, 0);
  for (const Segment& line : chain.lines) part.line(line.a, line.b);
  part.initialize();
  Entity mover(world, chain.shape);
  part.insert(mover, chain.start, Angle());
  return world;
}

/// The worst that was seen.
struct Figures {
  std::int64_t steps = 0;
  double share = HUGE_VAL;  ///< of the ideal progress, slack granted
  double loss = -HUGE_VAL;  ///< subunits beyond the share
  double lift = -HUGE_VAL;

  void print() const {
    std::cout << steps << " steps, most loss " << loss << " subunits beyond the promised share, highest " << lift
              << " subunits above the floor\n";
  }
};

/// Goes along the floor for so many ticks.
void expectKept(JudgedWorld& scene, const Floor& floor, Point velocity, int ticks, const Promise& promise,
                Figures& worst) {
  const double ideal = floor.progress(velocity);
  const double lowest = floor.lowest(scene.shape);
  const Point down = nearest(-60 * floor.up());
  for (int tick = 0; tick < 5; ++tick) scene.tick(down);
  for (int tick = 0; tick < ticks; ++tick) {
    const Point before = scene.at();
    SCOPED_TRACE("tick " + std::to_string(tick) + ", from " + testing::PrintToString(before));
    scene.tick(velocity);
    const double progress = floor.progress(scene.at() - before);
    const double lift = floor.height(scene.at()) + lowest;
    const double held = floor.height(scene.at() - before) - floor.height(velocity);
    worst.share = std::min(worst.share, (progress + promise.slack) / ideal);
    worst.loss = std::max(worst.loss, promise.share * ideal - progress);
    worst.lift = std::max(worst.lift, lift);
    ++worst.steps;
    ASSERT_GE(progress, promise.share * ideal - promise.slack);
    ASSERT_LE(lift, promise.lift);
    ASSERT_TRUE(held <= kUntold || !scene.rules.contacts.empty()) << "what holds it up is told";
    ASSERT_TRUE(scene.lawful());
  }
}

void expectCrossed(std::uint64_t seed, std::int32_t off, const Promise& promise, Figures& worst) {
  const std::string name = "seed " + std::to_string(seed) + ", ends off by " + std::to_string(off);
  SCOPED_TRACE(name);
  const Chain chain = chainFrom(seed, off);
  JudgedWorld scene(name, worldOf(chain), {.shape = chain.shape});
  expectKept(scene, chain.floor, chain.velocity, chain.ticks, promise, worst);
}

void expectAllCrossed(std::int64_t chains, std::int32_t off, const Promise& promise) {
  Figures worst;
  const auto count = static_cast<std::uint64_t>(judge::runLength(chains, 100 * chains));
  for (std::uint64_t seed = 0; seed < count && !testing::Test::HasFailure(); ++seed) {
    expectCrossed(seed, off, promise, worst);
  }
  worst.print();
  EXPECT_GE(worst.steps, 370 * chains);
}

TEST(JointsTest, OffByOneAtEachEndNothingSnags) { expectAllCrossed(1600, 1, kNearlyCollinear); }

TEST(JointsTest, OffByTwoAtEachEndNothingSticks) { expectAllCrossed(800, 2, kCoarse); }

/// A chain as a scene file, and how it was made.
struct Written {
  const char* name;
  Angle slope;
  std::int32_t off;
  int ticks;
};

const Written kWritten[] = {
    {"level", Angle(), 1, 98},
    {"diagonal", Angle(-4500), 1, 255},
    {"slanted", Angle(1114), 1, 134},
    {"rough", Angle(-933), 2, 264},
};

TEST(JointsTest, ChainsInFiles) {
  for (const Written& written : kWritten) {
    SCOPED_TRACE(written.name);
    HardScene scene(std::string("joints/") + written.name + ".scene");
    const Floor floor{turned({1, 0}, written.slope)};
    for (const Segment& line : scene.world.geometry().parts[0]->segments) {
      ASSERT_LE(std::abs(floor.height(line.a)), (written.off + 0.5) * std::numbers::sqrt2);
      ASSERT_LE(std::abs(floor.height(line.b)), (written.off + 0.5) * std::numbers::sqrt2);
    }
    Figures worst;
    expectKept(scene, floor, scene.velocity, written.ticks, written.off == 1 ? kNearlyCollinear : kCoarse, worst);
  }
}

}  // namespace
}  // namespace platon::hard_cases
