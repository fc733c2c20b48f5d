#include "shared/physics/instances.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <cstdlib>
#include <initializer_list>
#include <numbers>
#include <set>

#include "platon/exact/integer.h"
#include "platon/exact/precise_point.h"
#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "platon/physics/world.h"
#include "tests/shared/physics/maps.h"
#include "tests/shared/physics/shapes.h"
#include "tests/shared/physics/step/leg_checker.h"
#include "tests/sim/seeded_random.h"

namespace platon::instances_test {
namespace {

constexpr std::uint64_t kSeed = 606;
constexpr std::int32_t kMax = kCoordinateLimit - 1;

// Two parts that share an edge of length 20 000, at a different position and angle in part 2.
World turnedPair(Angle turn, Point edgeAt, const std::vector<Segment>& linesBehind = {}) {
  World world;
  const Segment edge{{10000, -10000}, {10000, 10000}};
  const Segment onto{edgeAt + rotate(edge.a, turn), edgeAt + rotate(edge.b, turn)};
  MapPart first(world, 1);
  first.warp(edge.a, edge.b, 2, onto.a, onto.b);
  first.initialize();
  MapPart second(world, 2);
  for (const Segment& line : linesBehind) second.line(line.a, line.b);
  second.warp(onto.b, onto.a, 1, edge.b, edge.a);
  second.initialize();
  return world;
}

const std::vector<std::int32_t> kFaceTurns = {0,     3600,  6000,  7200,  9000, 10800, 12000,
                                              14400, 18000, 25200, 30000, 1,    12345};

TEST(InstancesTest, InsertsInstancesBeforeTheirPartIsReached) {
  World world = twoStrips();
  Entity entity(world, square(100));
  MapPart(world, 1).insert(entity, {800, 0}, Angle());
  entity.setVelocity({95, 0});
  world.solve();
  EXPECT_EQ(world.view(0).size(), 1u) << "5 subunits from the edge";
  entity.setVelocity({2, 0});
  world.solve();
  EXPECT_EQ(world.view(0).size(), 2u) << "3 subunits from the edge";
}

// The edge is near the coordinate limit of the second part only.
TEST(InstancesTest, StopsAtTheCoordinateLimitBehindAnEdge) {
  for (const Angle turn : {Angle(), Angle(9000), Angle(6000)}) {
    const Point outwards = rotate(Point(kMax - 30000, 0), turn);
    World world = turnedPair(turn, outwards);
    Entity entity(world, square(100));
    MapPart(world, 1).insert(entity, {9000, 0}, Angle());
    for (int tick = 0; tick < 40; ++tick) {
      entity.setVelocity({100000, 3}, entity.rotation());
      world.solve();
      ASSERT_TRUE(world.accepts(world.save())) << "tick " << tick << ", turned by " << turn.centidegrees();
    }
    EXPECT_EQ(entity.part(), 2u);
    const Point position = entity.position();
    EXPECT_GT(squaredLength(position), squaredLength(Point(kMax - 15000, 0))) << "it stops near the limit";
  }
}

TEST(InstancesTest, DropsInstancesOnlyBeyondAMargin) {
  World world = twoStrips();
  Entity entity(world, square(100));
  MapPart(world, 1).insert(entity, {905, 0}, Angle());
  ASSERT_EQ(world.view(0).size(), 2u);
  const std::uint16_t id = world.view(0)[1].id;
  for (const std::int32_t position : {899, 894, 893, 898, 893}) {
    entity.setVelocity({position - entity.position().x, 0});
    world.solve();
    ASSERT_EQ(world.view(0).size(), 2u) << position;
    ASSERT_EQ(world.view(0)[1].id, id) << "the same one";
  }
  entity.setVelocity({-1, 0});
  world.solve();
  EXPECT_EQ(world.view(0).size(), 1u) << "8 subunits from the edge";
}

TEST(InstancesTest, TurnsBetweenPartsAreExact) {
  for (const std::int32_t turn : kFaceTurns) {
    World world = turnedPair(Angle(turn), {-3000, 70000});
    Entity entity(world, regular(16, 3000));
    MapPart(world, 1).insert(entity, {5000, 1234}, Angle(777));
    LegChecker checker(world);
    entity.setVelocity({1000, 100});
    for (int tick = 0; tick < 12; ++tick) world.solve(&checker);
    EXPECT_EQ(entity.part(), 2u) << turn;
    EXPECT_EQ(entity.rotation(), Angle(777) + Angle(turn)) << turn;
    EXPECT_EQ(entity.velocity(), rotate(Point(1000, 100), Angle(turn))) << turn;
    const Point expected = Point(-3000, 70000) + rotate(Point(17000, 2434), Angle(turn));
    EXPECT_LE(squaredLength(entity.position() - expected), 4 * 4) << turn;
    EXPECT_EQ(checker.faults(), "") << turn;
    EXPECT_EQ(entity.state().crossings, 1u);
  }
}

// In free motion, position plus remainder follow a straight line across the edge.
TEST(InstancesTest, RehomeKeepsTheRemainder) {
  using Wide = std::complex<long double>;
  const auto wide = [](Point point) {
    return Wide(static_cast<long double>(point.x), static_cast<long double>(point.y));
  };
  const auto turnOf = [](std::int32_t centidegrees) {
    return std::polar(1.0L, static_cast<long double>(centidegrees) * std::numbers::pi_v<long double> / 18000);
  };
  for (const std::int32_t turn : kFaceTurns) {
    World world = turnedPair(Angle(turn), {-3000, 70000});
    Entity entity(world, regular(16, 3000));
    MapPart(world, 1).insert(entity, {5000, 1234}, Angle());
    entity.setVelocity({1000, 100}, Angle(700));
    for (int tick = 0; tick < 12; ++tick) world.solve();
    ASSERT_EQ(entity.part(), 2u) << turn;
    const Segment onto = world.geometry().find(2)->warps[0].from;
    const Wide straight = Wide(5000, 1234) + 12.0L * turnOf(700) * Wide(1000, 100);
    const Wide expected = (wide(onto.a) + wide(onto.b)) / 2.0L + turnOf(turn) * (straight - Wide(10000, 0));
    const Wide found =
        wide(entity.position()) + wide(entity.state().remainder) / static_cast<long double>(PrecisePoint::kOne);
    EXPECT_LE(std::abs(found - expected), 0.001L) << turn;
  }
}

TEST(InstancesTest, CrossingBackReturnsToTheStart) {
  sim::SeededRandom random(kSeed);
  for (const std::int32_t turn : kFaceTurns) {
    for (int round = 0; round < 20; ++round) {
      World world = turnedPair(Angle(turn), {-3000, 70000});
      Entity entity(world, randomConvex(random, 2500));
      const Point start(6500, static_cast<std::int32_t>(random.below(10000)) - 5000);
      MapPart(world, 1).insert(entity, start, Angle());
      entity.setVelocity({6500 + static_cast<std::int32_t>(random.below(3000)), random.vector(3000).y});
      world.solve();
      ASSERT_EQ(entity.part(), 2u);
      entity.setVelocity(-entity.velocity());
      world.solve();
      ASSERT_EQ(entity.part(), 1u) << "seed " << kSeed << ", turn " << turn;
      ASSERT_EQ(entity.rotation(), Angle());
      const Point miss = entity.position() - start;
      ASSERT_LE(squaredLength(miss), 3 * 3) << "seed " << kSeed << ", turn " << turn << ", round " << round;
    }
  }
}

TEST(InstancesTest, CrossingBackAndForthDoesNotDrift) {
  for (const std::int32_t turn : kFaceTurns) {
    World world = turnedPair(Angle(turn), {-3000, 70000});
    Entity entity(world, regular(16, 3000));
    MapPart(world, 1).insert(entity, {9998, 1234}, Angle());
    LegChecker checker(world);
    for (int tick = 0; tick < 10000; ++tick) {
      entity.setVelocity({tick % 2 == 0 ? 5 : -5, 0}, entity.rotation());
      world.solve(tick % 100 < 4 ? &checker : nullptr);
      if (tick % 100 == 3) checker.forget();
    }
    const Point back =
        entity.part() == 1u ? entity.position() : rotate(entity.position() - Point(-3000, 70000), -Angle(turn));
    EXPECT_LE(std::abs(back.x - 9998), 9) << turn;
    EXPECT_LE(std::abs(back.y - 1234), 9) << turn;
    EXPECT_GT(entity.state().crossings, 9000u) << turn;
    EXPECT_EQ(checker.faults(), "") << turn;
    EXPECT_LE(world.view(0).size(), 2u);
  }
}

TEST(InstancesTest, IdsWrapAroundWithoutCollisions) {
  for (const std::uint16_t next : std::initializer_list<std::uint16_t>{0, 1, 65530, 65533, 65534}) {
    World world = twoStrips();
    Entity entity(world, square(100));
    MapPart(world, 1).insert(entity, {850, 0}, Angle());
    WorldState state = world.save();
    state.entities[0].nextId = next;
    ASSERT_TRUE(world.accepts(state));
    world.restore(state);
    LegChecker checker(world);
    for (int tick = 0; tick < 60; ++tick) {
      entity.setVelocity(tick % 6 < 3 ? Point(100, 0) : Point(-100, 0));
      world.solve(&checker);
      std::set<std::uint16_t> ids;
      for (const InstanceView& view : world.view(0)) {
        ASSERT_TRUE(ids.insert(view.id).second) << next << ", tick " << tick;
        ASSERT_NE(view.id, InstanceState::kNoParent);
        ASSERT_TRUE(view.home || view.hasParent) << next << ", tick " << tick;
      }
      ASSERT_TRUE(world.accepts(world.save()));
    }
    EXPECT_EQ(checker.faults(), "");
    EXPECT_EQ(world.view(0).size(), 1u) << "none is left behind";
  }
}

TEST(InstancesTest, IdsInUseAreSkipped) {
  World world = twoStrips();
  Entity entity(world, square(100));
  MapPart(world, 1).insert(entity, {850, 0}, Angle());
  WorldState state = world.save();
  state.entities[0].id = 5;
  state.entities[0].nextId = 5;
  world.restore(state);
  entity.setVelocity({100, 0});
  world.solve();
  ASSERT_EQ(world.view(0).size(), 2u);
  EXPECT_EQ(world.view(0)[0].id, 5);
  EXPECT_EQ(world.view(0)[1].id, 6);
}

TEST(InstancesTest, InsertsNothingOutsideTheCoordinateRange) {
  World world;
  MapPart first(world, 1);
  first.warp({1000, -1000}, {1000, 1000}, 2, {kMax - 10, 1000}, {kMax - 10, -1000});
  first.initialize();
  MapPart second(world, 2);
  second.warp({kMax - 10, -1000}, {kMax - 10, 1000}, 1, {1000, 1000}, {1000, -1000});
  second.initialize();
  Entity entity(world, square(200));
  MapPart(world, 1).insert(entity, {0, 0}, Angle());
  entity.setVelocity({100, 0});
  for (int tick = 0; tick < 20; ++tick) world.solve();
  EXPECT_EQ(entity.part(), 1u) << "the new instance would be out of range, so the edge blocks";
  EXPECT_GE(entity.position().x, 790);
  EXPECT_LE(entity.position().x, 800);
}

TEST(InstancesTest, AWarpWithoutReverseWarpBlocks) {
  World world;
  addLeftStrip(world);
  Entity entity(world, square(100));
  MapPart(world, 1).insert(entity, {0, 0}, Angle());
  entity.setVelocity({300, 40});
  for (int tick = 0; tick < 10; ++tick) world.solve();
  EXPECT_EQ(entity.part(), 1u);
  EXPECT_LE(entity.position().x, 900);
  EXPECT_EQ(entity.position().y, 400) << "it slides along";
  entity.setVelocity({-300, 0});
  world.solve();
  EXPECT_LE(entity.position().x, 600);
}

// A segment of the part behind crosses the edge, so that a new instance would overlap it.
TEST(InstancesTest, AnEdgeBlocksWhenNoPositionBehindItIsFree) {
  World world = twoStrips({}, {{{-1200, 0}, {0, 0}}});
  Entity entity(world, square(100));
  MapPart(world, 1).insert(entity, {850, 0}, Angle());
  LegChecker checker(world);
  entity.setVelocity({300, 0});
  for (int tick = 0; tick < 10; ++tick) world.solve(&checker);
  EXPECT_EQ(checker.faults(), "");
  EXPECT_EQ(entity.part(), 1u);
  EXPECT_EQ(world.view(0).size(), 1u);
  EXPECT_GE(entity.position().x, 890);
  EXPECT_LE(entity.position().x, 900);
}

TEST(InstancesTest, PartsMayWarpToThemselves) {
  World world;
  MapPart ring(world, 1);
  ring.warp({1000, -5000}, {1000, 5000}, 1, {-1000, -5000}, {-1000, 5000});
  ring.warp({-1000, 5000}, {-1000, -5000}, 1, {1000, 5000}, {1000, -5000});
  ring.initialize();
  Entity entity(world, square(100));
  MapPart(world, 1).insert(entity, {0, 0}, Angle());
  LegChecker checker(world);
  entity.setVelocity({350, 10});
  for (int tick = 0; tick < 40; ++tick) world.solve(&checker);
  EXPECT_EQ(checker.faults(), "");
  EXPECT_EQ(entity.position(), Point(0, 400)) << "seven times round";
  entity.setVelocity({35000, 0});
  for (int tick = 0; tick < 40; ++tick) world.solve(&checker);
  EXPECT_EQ(checker.faults(), "");
  EXPECT_EQ(entity.position().y, 400);
}

// The shape extends over both sides of the edge when it hits the segment.
TEST(InstancesTest, SegmentsBehindAnEdgeStopAllInstances) {
  for (const std::int32_t turn : kFaceTurns) {
    const Point edgeAt(-3000, 70000);
    const auto behind = [&](Point p) { return edgeAt + rotate(p, Angle(turn)); };
    World world = turnedPair(Angle(turn), edgeAt, {{behind({11000, -9000}), behind({11000, 9000})}});
    Entity entity(world, square(3000));
    MapPart(world, 1).insert(entity, {5000, 0}, Angle());
    LegChecker checker(world);
    entity.setVelocity({900, 0});
    for (int tick = 0; tick < 10; ++tick) world.solve(&checker);
    EXPECT_EQ(checker.faults(), "") << turn;
    EXPECT_EQ(entity.part(), 1u);
    EXPECT_LE(std::abs(entity.position().x - 8000), 4) << turn;
    const Point before = entity.position();
    for (int tick = 0; tick < 500; ++tick) world.solve();
    EXPECT_EQ(entity.position(), before) << turn << ": it rests there";
  }
}

// An edge only divides the map: the motion is that on one plane, up to rounding.
TEST(InstancesTest, SegmentsBehindAnEdgeActAsOnOnePlane) {
  struct Course {
    std::int32_t turn;
    Convex shape;
    std::vector<Segment> lines;  // from the middle of the edge
    Point at;
    Point velocity;
  };
  const Course courses[] = {
      {6000, regular(16, 1200), {{{-283, -1426}, {2558, 1833}}}, {9317, 84}, {-1602, -3803}},
      {18000, square(100), {{{143, -75}, {143, -75}}, {{40, -77}, {236, -174}}}, {9873, 123}, {383, -243}},
      {18000, square(100), {{{-183, 135}, {347, -147}}, {{-35, -94}, {154, 110}}}, {9764, -176}, {229, 158}},
  };
  const Point edgeAt(-3000, 70000);
  for (const Course& course : courses) {
    std::vector<Segment> onPlane;
    std::vector<Segment> behind;
    for (const Segment& line : course.lines) {
      const Segment shifted{line.a + Point(10000, 0), line.b + Point(10000, 0)};
      onPlane.push_back(shifted);
      behind.push_back(
          {edgeAt + rotate(shifted.a, Angle(course.turn)), edgeAt + rotate(shifted.b, Angle(course.turn))});
    }
    World plane;
    addPart(plane, 1, onPlane);
    World divided = turnedPair(Angle(course.turn), edgeAt, behind);
    Entity one(plane, course.shape);
    MapPart(plane, 1).insert(one, course.at, Angle());
    Entity other(divided, course.shape);
    MapPart(divided, 1).insert(other, course.at, Angle());
    one.setVelocity(course.velocity);
    other.setVelocity(course.velocity);
    for (int tick = 0; tick < 30; ++tick) {
      plane.solve();
      divided.solve();
      const Point there = other.part() == 1 ? one.position() : edgeAt + rotate(one.position(), Angle(course.turn));
      ASSERT_LE(squaredLength(other.position() - there), 4 * 4) << course.turn << ", tick " << tick;
    }
  }
}

// The floor behind the edge stops the entity where it rehomes. The component of (200, -50) along the ramp that begins
// there remains.
TEST(InstancesTest, RehomeForgetsTheStopOfTheOldFrame) {
  for (const std::int32_t turn : {0, 9000, 18000, 27000}) {
    const Point edgeAt(-3000, 70000);
    const auto behind = [&](Point p) { return edgeAt + rotate(p, Angle(turn)); };
    const Point corner = behind({10400, -300});
    World world = turnedPair(Angle(turn), edgeAt, {{behind({10050, -300}), corner}, {corner, behind({11400, 200})}});
    Entity entity(world, square(100));
    MapPart(world, 1).insert(entity, {9500, 0}, Angle());
    entity.setVelocity({1000, -250});
    world.solve();
    EXPECT_EQ(entity.part(), 2u);
    EXPECT_EQ(entity.position(), behind({10440, -130})) << turn;
  }
}

// Two floors, one on each side of an edge. The one behind it is three subunits higher.
TEST(InstancesTest, PassesAnEndThatASegmentBeforeTheEdgeReaches) {
  World world = twoStrips({{{-900, 0}, {1000, 0}}}, {{{-1000, 3}, {900, 3}}});
  Entity entity(world, square(100));
  MapPart(world, 1).insert(entity, {700, 100}, Angle());
  for (int tick = 0; tick < 8; ++tick) {
    entity.setVelocity({100, -3});
    world.solve();
  }
  EXPECT_EQ(entity.part(), 2u);
  EXPECT_EQ(entity.position(), Point(-500, 103));
}

// A diamond slides down a slope of 45°. A point protrudes from the slope where the centre is on the edge, so that the
// nudge past it moves the centre across.
TEST(InstancesTest, ANudgeAcrossAnEdgeKeepsItsDirection) {
  for (const std::int32_t turn : {0, 9000, 18000, 27000}) {
    const Point edgeAt(-3000, 70000);
    const auto behind = [&](Point p) { return edgeAt + rotate(p, Angle(turn)); };
    const Point point = behind({10001, -99});
    World world = turnedPair(Angle(turn), edgeAt, {{behind({9000, 900}), behind({11000, -1100})}, {point, point}});
    Entity entity(world, Convex({{0, -100}, {100, 0}, {0, 100}, {-100, 0}}));
    MapPart(world, 1).insert(entity, {9900, 100}, Angle());
    entity.setVelocity({150, -152});
    world.solve();
    EXPECT_EQ(entity.part(), 2u);
    EXPECT_LE(squaredLength(entity.position() - behind({10051, -51})), 2 * 2) << turn;
  }
}

Placement turnedBy(Angle angle) {
  Placement placement;
  placement.fromHome = rotationOf(angle);
  placement.toHome = rotationOf(-angle);
  placement.homeAnchor = {100, 200};
  placement.anchor = {-5000, 70};
  return placement;
}

TEST(Placement, IsAtTheAnchorWhenHomeIsAtItsAnchor) {
  for (const std::int32_t angle : {0, 3600, 9000, 12345}) {
    EXPECT_EQ(turnedBy(Angle(angle)).at({100, 200}), Point(-5000, 70));
  }
}

TEST(Placement, MovesWithHomeInItsOwnFrame) {
  EXPECT_EQ(turnedBy(Angle()).at({107, 197}), Point(-4993, 67));
  EXPECT_EQ(turnedBy(Angle::degrees(90)).at({107, 197}), Point(-4997, 77));
  EXPECT_EQ(turnedBy(Angle::degrees(180)).at({107, 197}), Point(-5007, 73));
}

TEST(Placement, RoundsTheWholeMoveOnce) {
  sim::SeededRandom random(kSeed);
  for (int i = 0; i < 5000; ++i) {
    const Angle angle(static_cast<std::int32_t>(random.below(Angle::kTurn)));
    const Placement placement = turnedBy(angle);
    const Point home = random.vector(1 << 20);
    ASSERT_EQ(placement.at(home), placement.anchor + rotate(home - placement.homeAnchor, angle))
        << "seed " << kSeed << ", round " << i;
  }
}

}  // namespace
}  // namespace platon::instances_test
