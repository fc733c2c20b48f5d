#include "shared/physics/entity_step.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "platon/exact/angle.h"
#include "platon/exact/integer.h"
#include "platon/exact/precise_point.h"
#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "platon/physics/world.h"
#include "tests/shared/physics/leg_checker.h"
#include "tests/shared/physics/plane_scene.h"
#include "tests/shared/physics/shapes.h"

namespace platon {
namespace {

constexpr std::uint64_t kSeed = 1001;

TEST(EntityStepTest, MovesFreelyByItsVelocity) {
  Scene scene({}, square(10), {5, 5});
  EXPECT_EQ(scene.step({1000, -3}), Point(1005, 2));
  EXPECT_EQ(scene.step({}), Point(1005, 2));
}

TEST(EntityStepTest, StopsAtASegmentAndSlidesAlongIt) {
  Scene scene({{{-1000, -20}, {1000, -20}}}, square(10), {0, 0});
  EXPECT_EQ(scene.step({30, -60}), Point(30, -10)) << "the component along the segment is kept";
  EXPECT_EQ(scene.step({-7, -1}), Point(23, -10));
  EXPECT_EQ(scene.step({0, 4}), Point(23, -6));
}

TEST(EntityStepTest, CornersStopTheWholeDisplacement) {
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

TEST(EntityStepTest, ShortSegmentsStopTheFastestEntity) {
  Scene scene({{{100000, 0}, {100000, 1}}}, square(10), {0, 0});
  EXPECT_EQ(scene.step({kVelocityLimit - 1, 0}).x, 100000 - 10);
  Scene point({{{100000, 3}, {100000, 3}}}, square(10), {0, 0});
  EXPECT_EQ(point.step({kVelocityLimit - 1, 0}).x, 100000 - 10);
}

class CountedContacts : public Rules {
 public:
  void contact(Entity&, const Contact&) override { ++count; }

  int count = 0;
};

// A nudge past the end would hide the contact from the rules.
TEST(EntityStepTest, SlidingOnASegmentEndIsAContact) {
  Scene scene({{{92, -100}, {92, -1000}}}, square(100), {0, 0});
  CountedContacts rules;
  scene.entity.setVelocity({5, -5});
  scene.world.solve(rules);
  EXPECT_EQ(scene.entity.position(), Point(5, 0));
  EXPECT_EQ(rules.count, 1);
}

class NormalsOfContacts : public Rules {
 public:
  void contact(Entity&, const Contact& contact) override { normals.push_back(contact.normal); }

  std::vector<Point> normals;
};

// The ideal path enters the upper edge 2^-21 subunits before its end. It leads past the edge on the right.
TEST(EntityStepTest, NoContactIsReportedWithAnEdgeThatThePathLeadsPast) {
  Scene scene({{{-100, 0}, {0, 0}}}, square(10), {5, 15});
  WorldState state = scene.world.save();
  state.entities[0].remainder = {-static_cast<std::int32_t>(PrecisePoint::kOne >> 21), 0};
  scene.world.restore(state);
  NormalsOfContacts rules;
  scene.entity.setVelocity({10, -10});
  scene.world.solve(rules);
  EXPECT_EQ(scene.entity.position(), Point(15, 5));
  ASSERT_EQ(rules.normals.size(), 1u);
  EXPECT_EQ(rules.normals[0].x, 0);
}

// In rationals, the body stops at (1/2, 1/2). (0, 1) and (1, 1) are outside of the line and equally near.
TEST(EntityStepTest, OfPlacesEquallyNearTheOuterOneIsTaken) {
  Scene scene({{{142, -60}, {-158, 40}}}, square(10), {10, 29});
  EXPECT_EQ(scene.step({-20, -60}), Point(1, 1));
}

// The ideal path leads along y = x / 1024 through a corridor as wide as the square, where no lattice point is free. The
// lattice path meets the end of the ceiling.
TEST(EntityStepTest, WhereNoPlaceIsFreeTheBodyMovesAsFarAsItCan) {
  Scene scene({{{10, -10}, {1034, -9}}, {{-10, 10}, {1014, 11}}}, square(10), {-256, 0});
  WorldState state = scene.world.save();
  state.entities[0].remainder = {0, -static_cast<std::int32_t>(PrecisePoint::kOne / 4)};
  scene.world.restore(state);
  EXPECT_EQ(scene.step({1024, 1}), Point(-20, 0));
  EXPECT_EQ(scene.entity.state().remainder, Point());
}

TEST(EntityStepTest, StaysInTheCoordinateRange) {
  Scene scene({}, square(10), {0, 0});
  for (int tick = 0; tick < 20; ++tick) {
    const Point at = scene.step({kVelocityLimit - 1, 1 - kVelocityLimit});
    ASSERT_TRUE(isCoordinate(at.x) && isCoordinate(at.y)) << tick;
  }
  EXPECT_GT(scene.entity.position().x, kCoordinateLimit - 3);
}

// Truncating each coordinate of the displacement to a contact would cross these segments.
TEST(EntityStepTest, RoundingNeverCausesAnOverlap) {
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

// In a rotated frame a velocity has no integer coordinates. In free motion every position is the lattice point nearest
// to the exact one.
TEST(RemainderTest, RotatedVelocitiesAreNotRounded) {
  for (const std::int32_t heading : {1, 3600, 6000, 7200, 12345, 30000}) {
    Scene scene({}, square(10), {5, -5});
    scene.entity.setVelocity({37, -11}, Angle(heading));
    const PrecisePoint velocity = rotatePrecise({37, -11}, rotationOf(Angle(heading)));
    PrecisePoint exact = precise({5, -5});
    for (int tick = 0; tick < 1000; ++tick) {
      scene.world.solve();
      exact = exact + velocity;
      const PrecisePoint left = exact - precise(scene.entity.position());
      ASSERT_LE(2 * std::max(std::abs(left.x), std::abs(left.y)), PrecisePoint::kOne) << heading << ", tick " << tick;
    }
  }
}

// (1, 0) rotated by 60° leaves a remainder of half a subunit, which would be rounded to a whole one.
TEST(RemainderTest, RemaindersWithoutVelocityMoveNothing) {
  Scene scene({}, square(10), {0, 0});
  scene.entity.setVelocity({1, 0}, Angle::degrees(60));
  scene.world.solve();
  ASSERT_EQ(scene.entity.position(), Point(1, 1));
  ASSERT_EQ(scene.entity.state().remainder.x, -PrecisePoint::kOne / 2);
  for (int tick = 0; tick < 4; ++tick) ASSERT_EQ(scene.step({}), Point(1, 1)) << tick;
}

TEST(RemainderTest, ContactsKeepTheRemainderAlongTheEdge) {
  Scene scene({{{100, -1000}, {100, 1000}}}, square(10), {0, 0});
  scene.entity.setVelocity({50, 0}, Angle(3600));
  for (int tick = 0; tick < 2; ++tick) scene.world.solve();
  ASSERT_EQ(scene.entity.position(), Point(81, 59));
  ASSERT_NE(scene.entity.state().remainder, Point());
  scene.world.solve();
  EXPECT_EQ(scene.entity.position().x, 90);
  EXPECT_EQ(scene.entity.state().remainder.x, 0);
  EXPECT_NE(scene.entity.state().remainder.y, 0);
}

// A state may say so, and so may a rehome, which rounds.
TEST(RemainderTest, AnIdealPlaceInsideAnObstacleIsPutOntoItsEdge) {
  Scene scene({{{-1000, -20}, {1000, -20}}}, square(10), {0, -10});
  WorldState state = scene.world.save();
  state.entities[0].remainder = {0, -static_cast<std::int32_t>(PrecisePoint::kOne / 4)};
  scene.world.restore(state);
  EXPECT_EQ(scene.step({0, -3}), Point(0, -10));
  EXPECT_EQ(scene.entity.state().remainder, Point());
}

struct RandomScene {
  const char* name;
  std::int32_t extent;
  std::int32_t lineLength;
  int lines;
  std::int32_t radius;
  std::int32_t speed;
};

TEST(EntityStepTest, NeverOverlapsRandomSegments) {
  const RandomScene scenes[] = {
      {"tiny numbers", 40, 12, 30, 4, 20},          {"small", 400, 200, 60, 20, 150},
      {"level", 400000, 200000, 150, 12288, 20000}, {"fast", 400000, 20000, 150, 12288, 1 << 27},
      {"splinters", 3000, 40, 400, 60, 500},        {"largest", 1 << 28, 1 << 27, 60, 1 << 20, 1 << 26},
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

TEST(EntityStepTest, StepsEndAmongManySegments) {
  std::vector<Segment> lines;
  for (int i = 0; i < 200; ++i) {
    const Point end = rotate(Point(4000, 0), Angle(i * 180));
    lines.push_back({{0, 0}, end});
    lines.push_back({end, rotate(Point(4000, 0), Angle(i * 180 + 9000))});
  }
  Scene scene(lines, square(3), {5000, 200});
  LegChecker checker(scene.world);
  sim::SeededRandom random(kSeed);
  std::uint64_t maxLegs = 0;
  for (int tick = 0; tick < 500; ++tick) {
    const std::uint64_t before = checker.legs();
    scene.entity.setVelocity(-scene.entity.position() + random.vector(500));
    scene.world.solve(&checker);
    maxLegs = std::max(maxLegs, checker.legs() - before);
  }
  EXPECT_EQ(checker.faults(), "");
  EXPECT_LE(maxLegs, static_cast<std::uint64_t>(EntityStep::kMaxLegs) + 1);
}

// I3 on one face.

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

// The wedge is too narrow for the lattice 32 subunits above the place where the ideal body rests.
TEST(EntityStepTest, InANarrowWedgeTheIdealPlaceFallsBackToThePosition) {
  Scene scene({{{70, -261}, {5, -7}}, {{-109, 127}, {-112, -82}}}, square(67), {-35, -182});
  for (int tick = 0; tick < 3; ++tick) scene.step({191, 93});
  EXPECT_EQ(scene.entity.position(), Point(-37, -172));
  EXPECT_EQ(scene.entity.state().remainder, Point());
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

TEST(EntityStepTest, OnAFloorThePositionIsTheFreeLatticePointNearestToTheIdealPlace) {
  for (const Point along : {Point(1000, 1), Point(997, 331), Point(600, -599), Point(30, 901)}) {
    const Segment floor{{-20 * along.x, -20 * along.y}, {20 * along.x, 20 * along.y}};
    Scene scene({floor}, square(50), Point(-along.y / 5, along.x / 5));
    const auto isFree = [&](Point place) {  // one corner of the square is the lowest
      const Point lowest = place + Point(along.y > 0 ? 50 : -50, along.x > 0 ? -50 : 50);
      return cross(along, lowest) >= 0;
    };
    for (int tick = 0; tick < 200; ++tick) {
      const Point at = scene.step({37, -61});
      const Point remainder = scene.entity.state().remainder;
      const auto distance = [&](Point place) {
        const PrecisePoint between = precise(place - at) - PrecisePoint{remainder.x, remainder.y};
        return between.x * between.x + between.y * between.y;
      };
      for (int x = -2; x <= 2; ++x) {
        for (int y = -2; y <= 2; ++y) {
          if (!isFree(at + Point(x, y))) continue;
          ASSERT_GE(distance(at + Point(x, y)), distance(at)) << along.x << " " << along.y << ", tick " << tick;
        }
      }
    }
  }
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
}  // namespace platon
