#include "shared/physics/entity_step.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "shared/exact/integer.h"
#include "shared/physics/entity.h"
#include "shared/physics/map_part.h"
#include "shared/physics/world.h"
#include "tests/shared/physics/leg_checker.h"
#include "tests/shared/physics/maps.h"
#include "tests/shared/physics/shapes.h"

namespace platon {
namespace {

constexpr std::uint64_t kSeed = 1001;

// One part with these lines and an entity in it.
struct Scene {
  Scene(const std::vector<Segment>& lines, const Convex& shape, Point at) : entity(make(lines, shape, at)) {}

  Entity make(const std::vector<Segment>& lines, const Convex& shape, Point at) {
    addPart(world, 0, lines);
    Entity made(world, shape);
    MapPart(world, 0).insert(made, at, Angle());
    return made;
  }
  Point step(Point velocity) {
    entity.setVelocity(velocity);
    world.solve();
    return entity.position();
  }

  World world;
  Entity entity;
};

TEST(EntityStepTest, MovesFreelyByItsVelocity) {
  Scene scene({}, square(10), {5, 5});
  EXPECT_EQ(scene.step({1000, -3}), Point(1005, 2));
  EXPECT_EQ(scene.step({}), Point(1005, 2));
}

TEST(EntityStepTest, StopsAtALineAndSlidesAlongIt) {
  Scene scene({{{-1000, -20}, {1000, -20}}}, square(10), {0, 0});
  EXPECT_EQ(scene.step({30, -60}), Point(30, -10)) << "the part along the line is kept whole";
  EXPECT_EQ(scene.step({-7, -1}), Point(23, -10));
  EXPECT_EQ(scene.step({0, 4}), Point(23, -6));
}

TEST(EntityStepTest, ACornerTakesAllOfIt) {
  Scene scene({{{-1000, -20}, {1000, -20}}, {{40, -1000}, {40, 1000}}}, square(10), {0, 0});
  EXPECT_EQ(scene.step({100, -100}), Point(30, -10));
  EXPECT_EQ(scene.step({100, -100}), Point(30, -10));
  EXPECT_EQ(scene.step({-100, -100}), Point(-70, -10));
}

TEST(EntityStepTest, FitsExactlyThroughAGap) {
  Scene scene({{{0, 10}, {0, 100}}, {{0, -10}, {0, -100}}}, square(10), {-50, 0});
  EXPECT_EQ(scene.step({100, 0}), Point(50, 0));
  Scene narrow({{{0, 9}, {0, 100}}, {{0, -10}, {0, -100}}}, square(10), {-50, 0});
  EXPECT_EQ(narrow.step({100, 0}).x, -10);
}

TEST(EntityStepTest, ThinLinesStopTheFastest) {
  Scene scene({{{100000, 0}, {100000, 1}}}, square(10), {0, 0});
  EXPECT_EQ(scene.step({kVelocityLimit - 1, 0}).x, 100000 - 10);
  Scene point({{{100000, 3}, {100000, 3}}}, square(10), {0, 0});
  EXPECT_EQ(point.step({kVelocityLimit - 1, 0}).x, 100000 - 10);
}

TEST(EntityStepTest, StaysInsideTheCoordinates) {
  Scene scene({}, square(10), {0, 0});
  for (int tick = 0; tick < 20; ++tick) {
    const Point at = scene.step({kVelocityLimit - 1, 1 - kVelocityLimit});
    ASSERT_TRUE(isCoordinate(at.x) && isCoordinate(at.y)) << tick;
  }
  EXPECT_GT(scene.entity.position().x, kCoordinateLimit - 3);
}

// Truncating each component of the way to a contact crosses such lines.
TEST(EntityStepTest, NeverEndsInsideALineByRounding) {
  for (int nx = -4; nx <= 4; ++nx) {
    for (int ny = -4; ny <= 4; ++ny) {
      if (nx == 0 && ny == 0) continue;
      const Segment line{{-ny * 50 - nx * 20, nx * 50 - ny * 20}, {ny * 50 - nx * 20, -nx * 50 - ny * 20}};
      for (int x = -12; x <= 12; ++x) {
        for (int y = -12; y <= 12; ++y) {
          Scene scene({line}, Convex(std::vector<Point>{{0, -3}, {4, 1}, {-2, 2}}), {0, 0});
          LegChecker checker(scene.world);
          scene.entity.setVelocity({x * 11, y * 11});
          scene.world.solve(&checker);
          ASSERT_EQ(checker.faults(), "") << nx << " " << ny << " " << x << " " << y;
        }
      }
    }
  }
}

struct RandomScene {
  const char* name;
  std::int32_t extent;
  std::int32_t lineLength;
  int lines;
  std::int32_t radius;
  std::int32_t speed;
};

TEST(EntityStepTest, FlungAmongRandomLinesItNeverOverlaps) {
  const RandomScene scenes[] = {
      {"tiny numbers", 40, 12, 30, 4, 20},     {"small", 400, 200, 60, 20, 150},
      {"level", 400000, 200000, 150, 12288, 20000}, {"fast", 400000, 20000, 150, 12288, 1 << 27},
      {"splinters", 3000, 40, 400, 60, 500},   {"largest", 1 << 28, 1 << 27, 60, 1 << 20, 1 << 26},
  };
  for (const RandomScene& kind : scenes) {
    sim::SeededRandom random(kSeed);
    for (int round = 0; round < 12; ++round) {
      World world;
      std::vector<Segment> lines;
      for (int i = 0; i < kind.lines; ++i) {
        const Point a = random.vector(kind.extent);
        lines.push_back({a, i % 9 == 0 ? a : a + random.vector(kind.lineLength)});
      }
      addPart(world, 0, lines);
      Entity entity(world, randomConvex(random, kind.radius));
      while (!entity.inserted()) {
        try {
          MapPart(world, 0).insert(entity, random.vector(kind.extent), Angle());
        } catch (const std::invalid_argument&) {
        }
      }
      LegChecker checker(world);
      for (int tick = 0; tick < 120; ++tick) {
        entity.setVelocity(random.vector(kind.speed));
        if (tick % 4 == 3) entity.rotate(static_cast<std::int32_t>(random.below(3000)) - 1500);
        world.solve(&checker);
      }
      ASSERT_EQ(checker.faults(), "") << kind.name << ", seed " << kSeed << ", round " << round;
    }
  }
}

TEST(EntityStepTest, PilesOfLinesEndTheStep) {
  std::vector<Segment> lines;
  for (int i = 0; i < 200; ++i) {
    const Point end = rotate(Point(4000, 0), Angle(i * 180));
    lines.push_back({{0, 0}, end});
    lines.push_back({end, rotate(Point(4000, 0), Angle(i * 180 + 9000))});
  }
  Scene scene(lines, square(3), {5000, 200});
  LegChecker checker(scene.world);
  sim::SeededRandom random(kSeed);
  std::uint64_t most = 0;
  for (int tick = 0; tick < 500; ++tick) {
    const std::uint64_t before = checker.legs();
    scene.entity.setVelocity(-scene.entity.position() + random.vector(500));
    scene.world.solve(&checker);
    most = std::max(most, checker.legs() - before);
  }
  EXPECT_EQ(checker.faults(), "");
  EXPECT_LE(most, static_cast<std::uint64_t>(EntityStep::kMostLegs) + 1);
}

// I3 on one face.

struct Floor {
  std::string name;
  std::vector<Segment> lines;
};

// Joints at every 10000 subunits, whose two ends are up to 2 subunits apart each way, in a shuffled order.
std::vector<Floor> floorsWithJoints(std::int32_t dx, std::int32_t dy) {
  std::vector<Floor> floors;
  sim::SeededRandom random(kSeed);
  for (const int off : {0, 1}) {
    Floor floor{"slope " + std::to_string(dx) + " " + std::to_string(dy) + ", off by " + std::to_string(off), {}};
    for (int i = -2; i < 12; ++i) {
      const auto nudge = [&] { return static_cast<std::int32_t>(random.below(2 * static_cast<std::uint64_t>(off) + 1)) - off; };
      floor.lines.push_back({Point(i * dx + nudge(), i * dy + nudge()),
                             Point((i + 1) * dx + nudge(), (i + 1) * dy + nudge())});
    }
    for (std::size_t i = floor.lines.size(); i > 1; --i) std::swap(floor.lines[i - 1], floor.lines[random.below(i)]);
    floors.push_back(floor);
  }
  return floors;
}

// Runs along a floor from (0, 0) towards (10 dx, 10 dy), pressed on it.
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
  for (int tick = 0; tick < 3000; ++tick) scene.step(down);   // settle
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
  for (const Point direction : {Point(10000, 0), Point(10000, 1), Point(9000, 2500), Point(8001, -4999), Point(10000, 37)}) {
    for (const Floor& floor : floorsWithJoints(direction.x, direction.y)) {
      for (const Convex& shape : {regular(16, 12288), square(9000), regular(5, 7000)}) {
        for (const std::int32_t press : {256, 512}) {
          ASSERT_NO_FATAL_FAILURE(expectSmoothRun(floor, shape, direction, press));
        }
      }
    }
  }
}

// I4.

void expectRest(const std::vector<Segment>& lines, const Convex& shape, Point above, Point gravity, const char* name,
                int ticks = 5000) {
  Scene scene(lines, shape, above);
  for (int tick = 0; tick < 3000; ++tick) scene.step(gravity);
  const Point rest = scene.entity.position();
  scene.entity.setVelocity(gravity);
  for (int tick = 0; tick < ticks; ++tick) scene.world.solve();
  EXPECT_EQ(scene.entity.position(), rest) << name;
}

TEST(RestTest, NothingMovesWhereNothingCan) {
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

TEST(RestTest, NothingMovesForLong) {
  const Convex ball = regular(16, 12288);
  expectRest({{{-90000, 0}, {90000, 0}}}, ball, {17, 20000}, {0, -256}, "flat", 100000);
  expectRest({{{-90000, 50000}, {0, 0}}, {{0, 0}, {90000, 60001}}}, ball, {0, 60000}, {0, -256}, "V notch", 100000);
  expectRest({{{-5000, 0}, {-5000, 0}}, {{5000, 77}, {5000, 77}}}, ball, {100, 20000}, {0, -256}, "points", 100000);
  expectRest({{{5, 0}, {5, -50000}}}, ball, {0, 12500}, {0, -256}, "end of a line", 100000);
}

TEST(RestTest, APressStraightIntoASlopeMovesNothing) {
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

// A slide led off the end of a line, and a nudge past that end back onto it, in turn, for ever.
TEST(RestTest, NothingIsNudgedBackOntoTheLineThatItSlidOff) {
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

// A nudge off either ledge would be free, but the point under the middle would stop it there at once.
TEST(RestTest, NothingIsNudgedToWhereTheNextLineStopsIt) {
  Scene scene({{{9, -10}, {50, -30}}, {{-9, -10}, {-50, -30}}, {{0, -10}, {0, -10}}}, square(10), {0, 0});
  for (int tick = 0; tick < 4; ++tick) ASSERT_EQ(scene.step({0, -100}), Point(0, 0)) << tick;
}

// It slides down a slope against a point two subunits above its bottom: a nudge over that would lift it.
TEST(RestTest, APressDownwardsLiftsNothing) {
  Scene scene({{{-510, 10}, {490, -30}}, {{15, -8}, {15, -8}}}, square(10), {0, 0});
  for (int tick = 0; tick < 4; ++tick) ASSERT_EQ(scene.step({0, -256}), Point(5, 0)) << tick;
}

TEST(RestTest, OnTheEndOfALine) {
  // The flat bottom of a square rests on an end as on anything, wherever it carries.
  for (const std::int32_t x : {-8000, -3000, 0, 5, 4000, 8990}) {
    expectRest({{{x, 0}, {x, -50000}}}, square(9000), {0, 9500}, {0, -256}, "end of a line");
    expectRest({{{x, 0}, {x - 50000, -20000}}}, square(9000), {0, 9500}, {0, -256}, "end of a slope");
  }
}

}  // namespace
}  // namespace platon
