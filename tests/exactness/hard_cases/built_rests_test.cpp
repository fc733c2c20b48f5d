// I4 in places that are built to find a body without rest: pushed constantly, it comes to rest or goes on, and never
// returns to a state of before.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "platon/game/player.h"
#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "platon/physics/world.h"
#include "tests/exactness/hard_cases/dice.h"
#include "tests/shared/physics/maps.h"
#include "tests/support/run/repetitions.h"

namespace platon::hard_cases::built_rests_test {
namespace {

struct Scene {
  std::vector<Segment> segments;
  Convex shape;
  Point start;
  Point velocity;
  int ticks;  // until it must rest, if it does
};

// Two segments that open by `angle`. Their ends, in any order, miss each other by up to 3 subunits. The body is pushed
// between them, so that a slide along each leads into the other; in a wedge it may only be pushed into it.
Scene between(Dice& dice, double angle, bool deep) {
  const double axis = dice.between(0, 2 * kPi);
  const std::int32_t gap = dice.below(4);
  const Point miss = dice.vector(gap);
  Segment first{{}, polar(dice.between(20000, 40000), axis + angle / 2)};
  Segment second{miss, polar(dice.between(20000, 40000), axis - angle / 2) + miss};
  if (dice.below(2) == 0) std::swap(first, second);
  if (dice.below(2) == 0) std::swap(first.a, first.b);
  if (dice.below(2) == 0) std::swap(second.a, second.b);
  const int kind = dice.below(4);
  const double radius = kind == 0 ? dice.between(60, 9000) : kind == 1 ? dice.between(40, 400) : kPlayerRadius;
  const Convex shape = kind < 2 ? dice.polygon(radius) : playerShape();
  const double away = 1.02 * radius / std::sin(angle / 2) + dice.between(5, 205);
  const double speed = dice.below(3) == 0 ? dice.between(2, 40) : dice.between(300, 4000);
  const double aside = deep ? angle / 2 : 0.95 * std::min(angle / 2, (kPi - angle) / 2);
  const Point velocity = polar(speed, axis + kPi + dice.between(-aside, aside));
  const double ticks = 400 + radius / speed * (deep ? 20 : 4);
  return {{first, second}, shape, polar(away, axis), velocity, static_cast<int>(std::min(ticks, 6000.0))};
}

// A valley with one to three more segments, which begin near the joint.
Scene crossed(std::uint64_t number) {
  Dice dice(6, number);
  Scene scene = between(dice, dice.between(160, 179.9) * kPi / 180, false);
  for (int more = 1 + dice.below(3); more > 0; --more) {
    const Point from = dice.vector(1 + dice.below(60));
    scene.segments.push_back({from, from + polar(dice.between(1, 20000), dice.between(0, 2 * kPi))});
  }
  return scene;
}

// Two parallel segments, exactly as far apart as the shape is wide; a third may close the corridor.
Scene corridor(Dice& dice) {
  const Convex shape = dice.polygon(dice.between(40, 4000));
  const Point along = polar(30000, dice.between(0, 2 * kPi));
  const auto isLower = [&](Point a, Point b) { return cross(along, a) < cross(along, b); };
  const auto [low, high] = std::minmax_element(shape.vertices().begin(), shape.vertices().end(), isLower);
  std::vector<Segment> segments{{*low - along, *low + along}, {*high - along, *high + along}};
  const Point aside(along.x / 10, along.y / 10);
  if (dice.below(3) == 0) segments.push_back({*low + aside, *high + aside});
  const double speed = dice.below(2) == 0 ? dice.between(1, 5) : dice.between(5, 400);
  return {segments, shape, {}, polar(speed, dice.between(0, 2 * kPi)), 400};
}

// Whether the body returns to a state of before without resting there.
bool isRestless(const Scene& scene) {
  World world;
  addPart(world, 0, scene.segments);
  Entity body(world, scene.shape);
  try {
    MapPart(world, 0).insert(body, scene.start, Angle());
  } catch (const std::invalid_argument&) {
    return false;  // rounded, the corridor is too narrow
  }
  body.setVelocity(scene.velocity);
  for (int tick = 0; tick < scene.ticks; ++tick) world.solve();
  constexpr int kWatched = 150;
  std::set<std::uint64_t> before;
  std::set<std::uint64_t> after;
  for (int tick = 0; tick < 2 * kWatched; ++tick) {
    world.solve();
    (tick < kWatched ? before : after).insert(world.hash());
  }
  return after.size() > 1 && std::includes(before.begin(), before.end(), after.begin(), after.end());
}

TEST(BuiltRestsTest, InAValleyWithAGapABodyRests) {
  for (std::uint64_t number = 0; number < static_cast<std::uint64_t>(repetitions(2000)); ++number) {
    Dice dice(1, number);
    ASSERT_FALSE(isRestless(between(dice, dice.between(160, 179.9) * kPi / 180, false))) << "scene " << number;
  }
}

// Where the next segment is near, a nudge leads no farther than to it. Of 20 000 scenes, some in which nudges were
// repeated for ever when only their end had to be ahead.
TEST(BuiltRestsTest, InAValleyAmongOtherSegmentsABodyRests) {
  constexpr std::uint64_t kScenes[] = {371, 893, 907, 1118, 1130, 1894, 1948, 2707, 3094, 3734};
  for (const std::uint64_t number : kScenes) EXPECT_FALSE(isRestless(crossed(number))) << "scene " << number;
}

TEST(BuiltRestsTest, InAWedgeABodyRests) {
  for (std::uint64_t number = 0; number < static_cast<std::uint64_t>(repetitions(1500)); ++number) {
    Dice dice(2, number);
    ASSERT_FALSE(isRestless(between(dice, dice.between(10, 160) * kPi / 180, true))) << "scene " << number;
  }
}

TEST(BuiltRestsTest, InACorridorThatTheLatticeDoesNotPassABodyRests) {
  for (std::uint64_t number = 0; number < static_cast<std::uint64_t>(repetitions(1000)); ++number) {
    Dice dice(3, number);
    ASSERT_FALSE(isRestless(corridor(dice))) << "scene " << number;
  }
}

// The player ran between places up to 13 subunits apart for ever.
TEST(BuiltRestsTest, InAValleyWithAGapTheRunningPlayerRests) {
  const Scene scene{
      {{{0, 0}, {36210, 16998}}, {{2, 1}, {-36501, -16364}}}, playerShape(), {-5132, 11184}, {1367, -2978}, 400};
  EXPECT_FALSE(isRestless(scene));
}

}  // namespace
}  // namespace platon::hard_cases::built_rests_test
