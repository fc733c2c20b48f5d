// Passing of segment ends: I3 on one face.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "platon/physics/entity.h"
#include "platon/physics/world.h"
#include "tests/shared/physics/plane_scene.h"
#include "tests/shared/physics/shapes.h"
#include "tests/shared/physics/step/leg_checker.h"

namespace platon::segment_ends_test {
namespace {

constexpr std::uint64_t kSeed = 1001;

struct Floor {
  std::string name;
  std::vector<Segment> lines;
};

// Joints every 10 000 subunits, with two ends that are up to 2 subunits apart on each axis; segments in random order.
std::vector<Floor> floorsWithJoints(std::int32_t dx, std::int32_t dy) {
  std::vector<Floor> floors;
  sim::SeededRandom random(kSeed);
  for (const int off : {0, 1}) {
    Floor floor{"slope " + std::to_string(dx) + " " + std::to_string(dy) + ", off by " + std::to_string(off), {}};
    for (int i = -2; i < 12; ++i) {
      const auto nudge = [&] {
        return static_cast<std::int32_t>(random.below(2 * static_cast<std::uint64_t>(off) + 1)) - off;
      };
      floor.lines.push_back(
          {Point(i * dx + nudge(), i * dy + nudge()), Point((i + 1) * dx + nudge(), (i + 1) * dy + nudge())});
    }
    for (std::size_t i = floor.lines.size(); i > 1; --i) std::swap(floor.lines[i - 1], floor.lines[random.below(i)]);
    floors.push_back(floor);
  }
  return floors;
}

// Runs along a floor from (0, 0) towards (10 dx, 10 dy), pressed against it.
void expectSmoothRun(const Floor& floor, const Convex& shape, Point direction, std::int32_t press) {
  const double length = std::hypot(direction.x, direction.y);
  const Point along(static_cast<std::int32_t>(std::lround(direction.x / length * 4096)),
                    static_cast<std::int32_t>(std::lround(direction.y / length * 4096)));
  const Point down(static_cast<std::int32_t>(std::lround(direction.y / length * press)),
                   static_cast<std::int32_t>(std::lround(-direction.x / length * press)));
  const std::int32_t reach = shape.bounds().high.x;
  const Point up(static_cast<std::int32_t>(std::lround(-direction.y / length * 1.5 * reach)),
                 static_cast<std::int32_t>(std::lround(direction.x / length * 1.5 * reach)));
  Scene scene(floor.lines, shape, Point(direction.x / 2, direction.y / 2) + up);
  for (int tick = 0; tick < 3000; ++tick) scene.step(down);  // settle
  const auto height = [&](Point p) { return (-direction.y * double(p.x) + direction.x * double(p.y)) / length; };
  const double settled = height(scene.entity.position());
  const std::int64_t end = 9 * squaredLength(direction);
  int ticks = 0;
  while (dot(scene.entity.position(), direction) < end) {
    const Point before = scene.entity.position();
    const Point after = scene.step(along + down);
    const double progress = static_cast<double>(dot(after - before, direction)) / length;
    ASSERT_GE(progress, 4096 * 0.99) << floor.name << " at (" << before.x << ", " << before.y << ")";
    ASSERT_LE(std::abs(height(after) - settled), 3 + 1) << floor.name << ": lifted or sunk";
    ASSERT_LT(++ticks, 1000);
  }
  ASSERT_GT(ticks, 10);
}

TEST(SlideOverJointsTest, NeitherSlowsNorLifts) {
  for (const Point direction :
       {Point(10000, 0), Point(10000, 1), Point(9000, 2500), Point(8001, -4999), Point(10000, 37)}) {
    for (const Floor& floor : floorsWithJoints(direction.x, direction.y)) {
      for (const Convex& shape : {regular(16, 12288), square(9000), regular(5, 7000)}) {
        for (const std::int32_t press : {256, 512}) {
          ASSERT_NO_FATAL_FAILURE(expectSmoothRun(floor, shape, direction, press));
        }
      }
    }
  }
}

// Segment ends that meet within a few subunits; the entity must pass them.
struct Passage {
  const char* name;
  Convex shape;
  std::vector<Segment> lines;
  Point at;
  Point velocity;
  std::int32_t least;  // x after 60 ticks
};

TEST(SlideOverJointsTest, PassesEverySegmentEnd) {
  const Passage passages[] = {
      {"segment ends off by up to 4 subunits",
       square(100),
       {{{-2638, -199}, {-3, 3}}, {{1, -1}, {2635, 199}}, {{2632, 201}, {5271, 404}}},
       {-1328, 48},
       {163, -3},
       5000},
      {"an end in front of the next segment",
       regular(5, 70),
       {{{-4, -1}, {1723, 237}}, {{-1719, -239}, {3, -3}}, {{1717, 243}, {3442, 479}}},
       {-873, -20},
       {67, -22},
       2500},
      {"an edge flat on the next segment",
       square(10),
       {{{1, -4}, {118, 18}}, {{115, 17}, {234, 32}}, {{-114, -21}, {-3, 3}}},
       {-60, 5},
       {6, -1},
       200},
      {"another segment close behind",
       square(100),
       {{{-1290, 50}, {2, 0}}, {{1250, -40}, {2530, -60}}, {{1, 2}, {1250, -38}}},
       {-630, 150},
       {30, -30},
       1000},
  };
  for (const Passage& passage : passages) {
    Scene scene(passage.lines, passage.shape, passage.at);
    LegChecker checker(scene.world);
    scene.entity.setVelocity(passage.velocity);
    for (int tick = 0; tick < 60; ++tick) scene.world.solve(&checker);
    EXPECT_GE(scene.entity.position().x, passage.least) << passage.name;
    EXPECT_EQ(checker.faults(), "") << passage.name;
  }
}

// A point and a slope below the two flanks; a nudge past the point lets the entity fall.
TEST(SlideOverJointsTest, PassesAPointSlightlyInsideTheFlank) {
  Scene scene({{{23, -106}, {23, -106}}, {{-70, -141}, {-70, -141}}, {{-73, -148}, {248, 13}}}, square(100),
              {-132, -21});
  for (int tick = 0; tick < 60; ++tick) scene.step({0, -263});
  EXPECT_LE(scene.entity.position().y, -10000);
}

// At the coordinate limit, the places from which the body would pass the end are beyond it.
TEST(SlideOverJointsTest, ANudgeStaysWithinTheCoordinateLimit) {
  const Convex diamond({{0, -1100}, {100, -1000}, {0, -900}, {-100, -1000}});
  const auto runFrom = [&](std::int32_t top) {
    const Point joint(0, top - 1101);
    Scene scene({{joint + Point(-300, 300), joint}, {joint + Point(2, 2), joint + Point(402, -398)}}, diamond,
                {-1, top});
    LegChecker checker(scene.world);
    scene.entity.setVelocity({64, -64});
    scene.world.solve(&checker);
    EXPECT_EQ(checker.faults(), "");
    return scene.entity.position();
  };
  EXPECT_EQ(runFrom(kCoordinateLimit - 1), Point(0, kCoordinateLimit - 2));
  EXPECT_GE(runFrom(kCoordinateLimit - 3).x, 60);
}

// A body leans on the end of a wall, and a point is six subunits inside of its corner.
TEST(SlideOverJointsTest, APointThatStandsAloneStopsTheBody) {
  const Convex octagon({{3365, -8823},
                        {8381, -3723},
                        {7901, 4005},
                        {2968, 8608},
                        {-3453, 8222},
                        {-8861, 2892},
                        {-8442, -3815},
                        {-3180, -8324}});
  Scene scene({{{8709, -7864}, {16490, -32344}}, {{8695, -7734}, {8695, -7734}}}, octagon, {843, -11980});
  for (int tick = 0; tick < 60; ++tick) scene.step({1206, 1015});
  EXPECT_EQ(scene.entity.position(), Point(800, -11745));
}

// The ideal path touches the obstacle of a point on the slope in a corner only, and leads past it.
TEST(SlideOverJointsTest, PointsOnASlopeChangeNothing) {
  constexpr std::int64_t kRoundings = 10000;  // of 200 ticks: 1.5 * 10^-4 subunits
  sim::SeededRandom random(kSeed);
  for (int round = 0; round < 1000; ++round) {
    const Point stride = random.vector(60) + Point(100, 0);
    const auto along = [&](std::int32_t strides) { return Point(strides * stride.x, strides * stride.y); };
    const Segment slope{along(-3000), along(3000)};
    std::vector<Segment> lines{slope};
    for (int i = 0; i < 40; ++i) {
      const Point on = along(static_cast<std::int32_t>(random.below(2000)) - 1000);
      lines.push_back({on, on});
    }
    const Convex shape = randomConvex(random, 3000);
    const Point start = along(-500) + Point(-200 * stride.y, 200 * stride.x);
    Scene plain({slope}, shape, start);
    Scene scene(lines, shape, start);
    const Point velocity = along(5) + random.vector(40) + Point(2 * stride.y, -2 * stride.x);
    for (int tick = 0; tick < 200; ++tick) {
      plain.step(velocity);
      scene.step(velocity);
      const EntityState& expected = plain.entity.state();
      const EntityState& found = scene.entity.state();
      const PrecisePoint between = precise(found.position - expected.position) +
                                   PrecisePoint{found.remainder.x - std::int64_t{expected.remainder.x},
                                                found.remainder.y - std::int64_t{expected.remainder.y}};
      ASSERT_LE(maxNorm(between), kRoundings) << "seed " << kSeed << ", round " << round << ", tick " << tick;
    }
  }
}

// The ideal body rests there, between a segment and the end of another one.
TEST(SlideOverJointsTest, ANudgeLeadsPastTheEndThatStopsTheBody) {
  Scene scene({{{90, -285}, {-131, -81}},
               {{123, -53}, {93, -170}},
               {{85, -283}, {-24, -269}},
               {{123, -53}, {63, -55}},
               {{89, -283}, {-106, -260}},
               {{176, -84}, {-283, -274}},
               {{127, -50}, {-236, -183}},
               {{-64, -176}, {-272, 50}},
               {{174, -87}, {-233, -294}},
               {{-246, -181}, {93, -185}}},
              square(81), {-343, -540});
  for (int tick = 0; tick < 6; ++tick) scene.step({267, 293});
  EXPECT_EQ(scene.entity.position(), Point(6, -364));
}

// The end of the next segment is 0.3 subunits above the floor. The steep flank of the body slides over it at 1/40 of
// the speed, but in 1/80 of the tick: as the ideal body does, and without a nudge.
TEST(SlideOverJointsTest, AnEndThatIsPastAtOnceNeedsNoNudge) {
  const Convex shape({{-1000, 1000}, {-500, 0}, {500, 0}, {510, 1000}, {0, 2000}});
  Scene scene({{{-20000, -2000}, {30, 3}}, {{7, 1}, {20007, 2001}}}, shape, {-600, -10});
  scene.step({1000, 15});
  const double onFloor = 107 - 0.003;                     // x on the way to the end
  const double speed = (10 * 1000 + 15) * 10 / 101.0;     // along x, on the floor and on the next segment
  const double left = 1 - onFloor / speed - 0.3003 / 25;  // of the tick, on the next segment
  const double one = static_cast<double>(PrecisePoint::kOne);
  EXPECT_NEAR(scene.entity.position().x + scene.entity.state().remainder.x / one, -493 + left * speed, 0.01);
}

}  // namespace
}  // namespace platon::segment_ends_test
