// I4 between two segments on the plane: an entity that rests in a wedge never moves again.
#include <gtest/gtest.h>

#include <iostream>
#include <stdexcept>
#include <vector>

#include "platon/game/player.h"
#include "tests/exactness/long_runs/every_step.h"
#include "tests/exactness/properties/plane_scene.h"
#include "tests/exactness/properties/seeded_cases.h"
#include "tests/exactness/step_check/run_length.h"
#include "tests/shared/game/real_face.h"
#include "tests/support/run/repetitions.h"

namespace platon::long_runs::wedge_rest_test {
namespace {

using oracle::RandomSource;
using properties::PlaneScene;
using step_check::toPoint;

// More ticks than a slide into the wedge takes at these speeds.
constexpr int kSettling = 600;

struct Pressed {
  PlaneScene scene;
  Point velocity;
};

std::ostream& operator<<(std::ostream& out, const Pressed& pressed) {
  const auto points = [&](const std::vector<Point>& list) {
    for (const Point point : list) out << " " << point.x << " " << point.y;
  };
  out << "shape";
  points(pressed.scene.shape);
  for (const Segment& line : pressed.scene.lines) {
    out << "\nline";
    points({line.a, line.b});
  }
  out << "\nentity";
  points(pressed.scene.entities);
  out << "\nvelocity";
  points({pressed.velocity});
  return out;
}

std::vector<Point> square(std::int32_t half) { return {{-half, -half}, {half, -half}, {half, half}, {-half, half}}; }

/// Expects that after settling the entity either never moves again or never returns to the same state. Returns true if
/// it rests.
bool expectRestOrEscape(const Pressed& pressed, std::int64_t ticks) {
  World world = pressed.scene.world();
  Entity(world, 0).setVelocity(pressed.velocity);
  for (int tick = 0; tick < kSettling; ++tick) world.solve();
  const WorldState settled = world.save();
  world.solve();
  const bool still = world.save() == settled;
  EveryStep everyStep;
  for (std::int64_t tick = 1; tick < ticks; ++tick) {
    if (still != (world.save() == settled)) {
      ADD_FAILURE() << (still ? "moves after it rested\n" : "returns to an earlier state\n") << pressed;
      return false;
    }
    tick % 2 == 0 ? world.solve() : world.solve(&everyStep);
  }
  return still;
}

TEST(WedgeRestTest, RestsInTheSmallestWedges) {
  for (const Point velocity : {Point(0, -3), Point(0, -4), Point(1, -3), Point(-2, -6)}) {
    const PlaneScene valley{square(1), {{{0, 0}, {-2, 1}}, {{0, 0}, {2, 1}}}, {{0, 11}}, 1};
    expectRestOrEscape({valley, velocity}, 100);
    const PlaneScene skewed{square(1), {{{0, 0}, {-8, 5}}, {{0, 0}, {6, -1}}}, {{0, 11}}, 1};
    expectRestOrEscape({skewed, velocity}, 100);
  }
}

// Starts between the segments; the velocity points towards their apex, varied by up to a third.
Pressed anyWedge(RandomSource& random) {
  const std::int64_t scale = std::int64_t{1} << random.between(3, 15);
  Pressed pressed;
  pressed.scene.shape = random.oneIn(2) ? playerShape().vertices() : square(static_cast<std::int32_t>(scale + 10));
  const std::int64_t size = Convex(pressed.scene.shape).bounds().high.x;
  const Point tip = toPoint(random.vector(5));
  const Point one = toPoint(random.vector(20 * size));
  const Point other = toPoint(random.vector(20 * size));
  pressed.scene.lines = {{tip, tip + one}, {tip, tip + other}};
  const Real axis = (1 / (length(real(one)) + 1)) * real(one) + (1 / (length(real(other)) + 1)) * real(other);
  const Real outwards = (1 / (length(axis) + 0.01)) * axis;
  pressed.scene.entities = {nearest(static_cast<double>(size * random.between(1, 6)) * outwards)};
  const double speed = random.oneIn(3) ? 16 : 300;
  pressed.velocity = nearest(-speed * outwards) + toPoint(random.vector(static_cast<std::int64_t>(speed / 3)));
  return pressed;
}

TEST(WedgeRestTest, RestsInRandomWedges) {
  const std::int64_t ticks = step_check::isLong() ? 100000 : 8;
  std::int64_t resting = 0;
  properties::forEachCase(repetitions(6000), [&](RandomSource& random) {
    const Pressed pressed = anyWedge(random);
    try {
      resting += expectRestOrEscape(pressed, ticks) ? 1 : 0;
    } catch (const std::invalid_argument&) {  // the start is not free
    }
  });
  std::cout << resting << " entities rest\n";
  EXPECT_GE(resting, repetitions(200));
}

}  // namespace
}  // namespace platon::long_runs::wedge_rest_test
