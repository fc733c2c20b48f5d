#include "shared/physics/step/entity_step.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string>

#include "platon/exact/angle.h"
#include "platon/exact/integer.h"
#include "platon/exact/precise_point.h"
#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "platon/physics/world.h"
#include "tests/shared/physics/plane_scene.h"
#include "tests/shared/physics/shapes.h"
#include "tests/shared/physics/step/leg_checker.h"
#include "tests/shared/physics/step/step_parts.h"

namespace platon::entity_step_test {
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
  scene.world.setRules(rules);
  scene.world.solve();
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
  scene.world.setRules(rules);
  scene.world.solve();
  EXPECT_EQ(scene.entity.position(), Point(15, 5));
  ASSERT_EQ(rules.normals.size(), 1u);
  EXPECT_EQ(rules.normals[0].x, 0);
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
// A step that is watched goes the whole way; others fly freely.
class Watcher : public StepObserver {
 public:
  void leg(std::uint32_t, std::span<const InstanceView>) override {}
};

TEST(RemainderTest, RotatedVelocitiesAreNotRounded) {
  Watcher watcher;
  for (StepObserver* const observer : {static_cast<StepObserver*>(nullptr), static_cast<StepObserver*>(&watcher)}) {
    for (const std::int32_t heading : {1, 3600, 6000, 7200, 12345, 30000}) {
      Scene scene({}, square(10), {5, -5});
      scene.entity.setVelocity({37, -11}, Angle(heading));
      const PrecisePoint velocity = rotatePrecise({37, -11}, rotationOf(Angle(heading)));
      PrecisePoint exact = precise({5, -5});
      for (int tick = 0; tick < 1000; ++tick) {
        scene.world.solve(observer);
        exact = exact + velocity;
        const PrecisePoint left = exact - precise(scene.entity.position());
        ASSERT_LE(2 * std::max(std::abs(left.x), std::abs(left.y)), PrecisePoint::kOne) << heading << ", tick " << tick;
      }
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
  EXPECT_LE(maxLegs, static_cast<std::uint64_t>(StepLimits::kMaxLegs) + 1);
}

class RotateByTest : public StepParts {
 protected:
  // Returns the segment that stopped the rotation.
  std::optional<SegmentRef> turn(std::int32_t centidegrees) {
    const std::size_t events = events_.size();
    rotateBy(step(), centidegrees);
    for (const StepEvents::Event& event : events_.since(events)) {
      if (event.kind == StepEvents::Kind::kTouch) return event.contact.segment;
    }
    return std::nullopt;
  }
  void place(const Convex& shape, std::uint32_t part, Point at) {
    Entity entity(world_, shape);
    MapPart(world_, part).insert(entity, at, Angle());
    start();
  }
};

TEST_F(RotateByTest, TurnsByTheWholeAngleWhereNothingBlocks) {
  build({{{-100, -50}, {100, -50}}});
  EXPECT_FALSE(turn(12345));
  EXPECT_EQ(state_.angle, Angle(12345));
  EXPECT_FALSE(turn(-345));
  EXPECT_EQ(state_.angle, Angle(12000));
}

// The corner of the square, 1414 from its centre, meets the floor 1200 below it at 45° - acos(1200 / 1414) = 13.05°.
TEST_F(RotateByTest, StopsAtTheLastFreeAngleAndSaysSo) {
  addPart(world_, 0, {{{-9000, -1200}, {9000, -1200}}});
  place(square(1000), 0, {0, 0});
  ASSERT_TRUE(turn(4500));
  EXPECT_NEAR(state_.angle.centidegrees(), 1305, 5);
  const Angle last = state_.angle;
  EXPECT_TRUE(turn(1)) << "not a centidegree more";
  EXPECT_EQ(state_.angle, last);
  EXPECT_FALSE(turn(-100));
}

TEST_F(RotateByTest, InsertsTheInstancesThatTheShapeReaches) {
  buildStrips({880, 0});
  ASSERT_EQ(instances_.all().size(), 1u);
  EXPECT_FALSE(turn(4500));
  EXPECT_EQ(instances_.all().size(), 2u) << "a corner is over the edge";
}

TEST_F(RotateByTest, ASegmentBehindAnEdgeBlocks) {
  buildStrips({880, 0}, {{{-985, -500}, {-985, 500}}});
  const auto blocker = turn(4500);
  ASSERT_TRUE(blocker);
  EXPECT_EQ(blocker->part, 2u);
  EXPECT_LT(state_.angle.centidegrees(), 4500);
}

}  // namespace
}  // namespace platon::entity_step_test
