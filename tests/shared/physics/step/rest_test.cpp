// I4: an entity at rest does not move at all.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "platon/exact/precise_point.h"
#include "shared/physics/tolerances.h"
#include "tests/shared/physics/plane_scene.h"
#include "tests/shared/physics/shapes.h"

namespace platon::rest_test {
namespace {

void expectRest(const std::vector<Segment>& lines, const Convex& shape, Point above, Point gravity, const char* name,
                int ticks = 5000) {
  Scene scene(lines, shape, above);
  for (int tick = 0; tick < 3000; ++tick) scene.step(gravity);
  scene.entity.setVelocity(gravity);
  const EntityState rest = scene.entity.state();
  for (int tick = 0; tick < ticks; ++tick) {
    scene.world.solve();
    ASSERT_EQ(scene.entity.position(), rest.position) << name << ", tick " << tick;
    ASSERT_EQ(scene.entity.state().remainder, rest.remainder) << name << ", tick " << tick;
  }
}

TEST(RestTest, ComesToRest) {
  const Point gravity(0, -256);
  const Convex ball = regular(16, 12288);
  for (const Convex& shape : {ball, square(9000), regular(5, 7000), regular(3, 9000)}) {
    expectRest({{{-90000, 0}, {90000, 0}}}, shape, {17, 20000}, gravity, "flat");
    expectRest({{{-90000, 50000}, {0, 0}}, {{0, 0}, {90000, 60001}}}, shape, {0, 60000}, gravity, "V notch");
    expectRest({{{-90000, 90001}, {3, 0}}, {{-3, 0}, {90000, 20000}}}, shape, {100, 60000}, gravity, "crossing notch");
    expectRest({{{-90000, 0}, {90000, 0}}, {{20000, -9}, {20000, 90000}}}, shape, {7000, 20000}, {100, -256}, "corner");
    expectRest({{{-5000, 0}, {-5000, 0}}, {{5000, 77}, {5000, 77}}}, shape, {100, 20000}, gravity, "two points");
    expectRest({{{-90000, 0}, {90000, 1}}}, shape, {17, 20000}, gravity, "nearly flat");
  }
}

// Each of these segments leads a slide to another one that leads it back, or to an end.
TEST(RestTest, ReversedSlidesStop) {
  expectRest({{{133, -97}, {417, -59}}, {{-12, -82}, {84, -98}}}, regular(5, 70), {37, 99}, {0, -54}, "line to line");
  expectRest({{{0, -15}, {0, -15}}, {{-8, -19}, {29, -114}}, {{-16, -17}, {-66, -2}}, {{9, 6}, {9, 6}}}, square(10),
             {21, 6}, {-29, -7}, "point, line and point");
  expectRest({{{108, -56}, {232, 98}}, {{194, -31}, {359, 119}}, {{156, 28}, {118, -70}}, {{78, -53}, {-541, -89}}},
             square(100), {-203, 170}, {43, -32}, "ends of lines");
}

// In rationals, the body rests at (37.76, 80.96), between the third segment and the first.
TEST(RestTest, RestsWhereTheIdealBodyDoes) {
  Scene scene({{{108, -56}, {232, 98}}, {{194, -31}, {359, 119}}, {{156, 28}, {118, -70}}, {{78, -53}, {-541, -89}}},
              square(100), {-203, 170});
  for (int tick = 0; tick < 100; ++tick) scene.step({43, -32});
  const EntityState& state = scene.entity.state();
  const PrecisePoint place = precise(state.position) + PrecisePoint{state.remainder.x, state.remainder.y};
  EXPECT_LE(std::abs(place.x - PrecisePoint::kOne * 3776 / 100), Tolerances::kOnEdge);
  EXPECT_LE(std::abs(place.y - PrecisePoint::kOne * 8096 / 100), Tolerances::kOnEdge);
  EXPECT_LE(squaredLength(state.position - Point(38, 81)), 1);
}

TEST(RestTest, StaysAtRestForLong) {
  const Convex ball = regular(16, 12288);
  expectRest({{{-90000, 0}, {90000, 0}}}, ball, {17, 20000}, {0, -256}, "flat", 100000);
  expectRest({{{-90000, 50000}, {0, 0}}, {{0, 0}, {90000, 60001}}}, ball, {0, 60000}, {0, -256}, "V notch", 100000);
  expectRest({{{-5000, 0}, {-5000, 0}}, {{5000, 77}, {5000, 77}}}, ball, {100, 20000}, {0, -256}, "points", 100000);
  expectRest({{{5, 0}, {5, -50000}}}, ball, {0, 12500}, {0, -256}, "end of a line", 100000);
}

TEST(RestTest, PressingIntoASlopeMovesNothing) {
  for (const Point slope : {Point(3, 1), Point(1, 1), Point(7, -3), Point(-2, 5), Point(1000, 1), Point(16384, 9459)}) {
    const double length = std::hypot(slope.x, slope.y);
    const auto stretched = [](Point vector, double factor) {
      return Point(static_cast<std::int32_t>(std::lround(vector.x * factor)),
                   static_cast<std::int32_t>(std::lround(vector.y * factor)));
    };
    const Point far = stretched(slope, 90000 / length);
    const Point above = stretched(perpendicular(slope), 15000 / length);
    const Point press = stretched(-perpendicular(slope), 300 / length);
    expectRest({{-far, far}}, regular(16, 9000), above, press, "ball on a slope");
    expectRest({{-far, far}}, square(9000), above, press, "square on a slope");
  }
}

// The entity must not slide off the end of a segment and be nudged back onto it, again and again.
TEST(RestTest, IsNotNudgedBackOntoItsLastSlide) {
  struct {
    Segment line;
    Convex shape;
    Point start;
    Point velocity;
  } const scenes[] = {{{{123, -3}, {-243, 150}}, Convex({{16, 49}, {35, -43}, {58, 16}}), {-78, -143}, {2, 11}},
                      {{{151, 228}, {645, -509}}, Convex({{-86, -15}, {-82, -112}, {24, 55}}), {17, -158}, {73, 51}},
                      {{{-7, -12}, {30, -7}}, Convex({{0, -3}, {4, 1}, {-2, 2}}), {13, 0}, {0, -8}}};
  for (const auto& [line, shape, start, velocity] : scenes) {
    Scene scene({line}, shape, start);
    for (int tick = 0; tick < 2000; ++tick) scene.step(velocity);
    EXPECT_GT(dot(scene.entity.position() - start, velocity), 1000 * squaredLength(velocity)) << "it falls past";
  }
}

// A nudge off either ledge would be free, but the point in the middle would stop the entity immediately.
TEST(RestTest, IsNotNudgedToAnImmediateStop) {
  Scene scene({{{98, -100}, {500, -300}}, {{-98, -100}, {-500, -300}}, {{0, -100}, {0, -100}}}, square(100), {0, 0});
  for (int tick = 0; tick < 4; ++tick) ASSERT_EQ(scene.step({0, -100}), Point(0, 0)) << tick;
}

// The entity slides down a slope against a point 2 subunits above its bottom edge. A nudge over the point would lift
// it.
TEST(RestTest, PressingDownwardsLiftsNothing) {
  Scene scene({{{-5100, 100}, {4900, -300}}, {{105, -98}, {105, -98}}}, square(100), {0, 0});
  for (int tick = 0; tick < 4; ++tick) ASSERT_EQ(scene.step({0, -256}), Point(5, 0)) << tick;
}

TEST(RestTest, RestsOnSegmentEnds) {
  // The bottom edge of a square rests on a segment end at any x.
  for (const std::int32_t x : {-8000, -3000, 0, 5, 4000, 8990}) {
    expectRest({{{x, 0}, {x, -50000}}}, square(9000), {0, 9500}, {0, -256}, "end of a line");
    expectRest({{{x, 0}, {x - 50000, -20000}}}, square(9000), {0, 9500}, {0, -256}, "end of a slope");
  }
}

}  // namespace
}  // namespace platon::rest_test
