// Rules::pierce decides during a step which segments block, and what is overlapped stays pierced until it is left.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "platon/physics/world.h"
#include "tests/shared/physics/maps.h"
#include "tests/shared/physics/recorded_rules.h"
#include "tests/shared/physics/shapes.h"

namespace platon::pierce_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// A square of 20 by 20 in part 0. The segments of `rules.pierceable` are open doors, the others are closed.
class DoorTest : public testing::Test {
 protected:
  DoorTest() { world.setRules(rules); }

  void build(const std::vector<Segment>& lines, Point at) {
    addPart(world, 0, lines);
    entity.emplace(world, square(10));
    MapPart(world, 0).insert(*entity, at, Angle());
  }
  std::vector<std::string> step(Point velocity) {
    entity->setVelocity(velocity);
    world.solve();
    return rules.take();
  }
  std::vector<std::string> turn(std::int32_t centidegrees) {
    entity->rotate(centidegrees);
    return step({0, 0});
  }
  void open(std::uint32_t door) { rules.pierceable.insert({0, door}); }
  void close(std::uint32_t door) { rules.pierceable.erase({0, door}); }

  RecordedRules rules;
  World world;
  std::optional<Entity> entity;
};

// The entity could not move any more.
TEST_F(DoorTest, ADoorThatClosesOnABodyLetsItOut) {
  open(0);
  build({{{0, -100}, {0, 100}}}, {-15, 0});
  EXPECT_THAT(step({10, 0}), ElementsAre("begin 0:0", "over 0:0"));
  close(0);
  EXPECT_THAT(step({10, 0}), ElementsAre("over 0:0"));
  EXPECT_THAT(step({-3, 5}), ElementsAre("over 0:0")) << "in any direction";
  EXPECT_THAT(step({20, 0}), ElementsAre("end 0:0"));
  EXPECT_EQ(entity->position(), Point(22, 5));
  EXPECT_THAT(step({-20, 0}), ElementsAre("contact 0:0")) << "it is closed";
  EXPECT_EQ(entity->position(), Point(10, 5));
}

TEST_F(DoorTest, ADoorThatClosesOnABodyDoesNotLockAnotherOne) {
  open(0);
  build({{{0, -100}, {0, 100}}}, {-15, 0});
  step({10, 0});
  close(0);
  Entity other(world, square(10));
  EXPECT_THROW(MapPart(world, 0).insert(other, {5, 50}, Angle()), std::invalid_argument);
  MapPart(world, 0).insert(other, {30, 50}, Angle());
  other.setVelocity({-50, 0});
  EXPECT_THAT(step({0, 0}), ElementsAre("over 0:0", "contact 0:0"));
  EXPECT_EQ(other.position(), Point(10, 50));
}

// The velocity leads out of the door, a point, and against a slope that leads back into it.
TEST_F(DoorTest, AClosedDoorThatIsLeftBlocksInTheSameStep) {
  open(0);
  addPart(world, 0, {{{0, 0}, {0, 0}}, {{3000, -500}, {200, 5100}}});
  entity.emplace(world, square(1000));
  MapPart(world, 0).insert(*entity, {900, -800}, Angle());
  EXPECT_THAT(step({0, 0}), ElementsAre("begin 0:0", "over 0:0"));
  const WorldState inside = world.save();
  EXPECT_THAT(step({1000, 3000}), ElementsAre("end 0:0", "contact 0:1", "begin 0:0", "end 0:0"));
  world.restore(inside);
  close(0);
  EXPECT_THAT(step({1000, 3000}), ElementsAre("end 0:0", "contact 0:1", "contact 0:0", "contact 0:1", "contact 0:0"))
      << "it is caught between the door and the slope";
}

TEST_F(DoorTest, ARestoredBodyInsideAClosedDoorMoves) {
  open(0);
  build({{{0, -100}, {0, 100}}, {{40, -100}, {40, 100}}}, {0, 0});
  step({0, 0});
  const WorldState inside = world.save();
  step({50, 0});
  close(0);
  world.restore(inside);
  EXPECT_THAT(step({5, 0}), ElementsAre("over 0:0")) << "the contact has begun before";
  EXPECT_THAT(step({90, 0}), ElementsAre("end 0:0", "contact 0:1"));
}

TEST_F(DoorTest, AFreshBodyInsideADoorThatClosesMoves) {
  open(0);
  build({{{0, -100}, {0, 100}}}, {0, 0});
  close(0);
  EXPECT_THAT(step({5, 0}), ElementsAre("begin 0:0", "over 0:0"));
  EXPECT_THAT(step({5, 0}), ElementsAre("end 0:0"));
}

TEST_F(DoorTest, ABodyTurnsOutOfAClosedDoorButNotIntoIt) {
  open(0);
  build({{{12, -100}, {12, 100}}}, {0, 0});
  EXPECT_THAT(turn(4500), ElementsAre("begin 0:0", "over 0:0"));
  close(0);
  EXPECT_THAT(turn(-1000), ElementsAre("over 0:0"));
  EXPECT_THAT(turn(-3500), ElementsAre("end 0:0"));
  EXPECT_EQ(entity->rotation(), Angle());
  EXPECT_THAT(turn(4500), ElementsAre("touch 0:0"));
}

// The ideal place is inside of the door by less than a subunit when the lattice position has left it.
TEST_F(DoorTest, ABodyThatHasJustLeftAClosedDoorRestsOnIt) {
  for (std::int32_t slope = 1; slope < 40; ++slope) {
    World scene;
    RecordedRules doors;
    doors.pierceable = {{0, 0}};
    scene.setRules(doors);
    addPart(scene, 0, {{{-1000, -10 * slope}, {1000, 10 * slope}}});
    Entity body(scene, square(100));
    MapPart(scene, 0).insert(body, {0, -300}, Angle());
    doors.take();
    body.setVelocity({7, 31});
    std::vector<std::string> calls;
    for (int tick = 0; tick < 100 && (calls.empty() || calls.back() != "end 0:0"); ++tick) {
      scene.solve();
      calls = doors.take();
    }
    ASSERT_EQ(calls.back(), "end 0:0");
    doors.pierceable.clear();
    body.setVelocity({0, -300});
    for (int tick = 0; tick < 5; ++tick) scene.solve();
    EXPECT_GT(cross(Point(100, slope), body.position()), 0) << "slope " << slope;
    EXPECT_THAT(doors.take(), testing::Each("contact 0:0")) << "slope " << slope;
  }
}

// Blocks entities that do not move from its right side to its left side.
class OneWay : public RecordedRules {
 public:
  bool pierce(const Entity& entity, const SegmentRef& segment) const override {
    const Point velocity = rotate(entity.velocity(), -segment.toHome);
    return segment.warp || cross(segment.ends.b - segment.ends.a, velocity) > 0;
  }
};

TEST(OneWayTest, APlatformLetsABodyThroughFromBelowOnly) {
  World world;
  OneWay rules;
  world.setRules(rules);
  addPart(world, 0, {{{-100, 0}, {100, 0}}});
  Entity entity(world, square(10));
  MapPart(world, 0).insert(entity, {0, -40}, Angle());
  const auto step = [&](Point velocity) {
    entity.setVelocity(velocity);
    world.solve();
    return rules.take();
  };
  EXPECT_THAT(step({0, 35}), ElementsAre("begin 0:0", "over 0:0"));
  EXPECT_THAT(step({2, -3}), ElementsAre("over 0:0")) << "it falls back as long as it overlaps the platform";
  EXPECT_THAT(step({0, -40}), ElementsAre("end 0:0"));
  EXPECT_THAT(step({0, 80}), ElementsAre("begin 0:0", "end 0:0"));
  EXPECT_EQ(entity.position(), Point(2, 32));
  for (int tick = 0; tick < 3; ++tick) EXPECT_THAT(step({3, -30}), ElementsAre("contact 0:0"));
  EXPECT_EQ(entity.position(), Point(11, 10)) << "it stands on the platform and walks";
  EXPECT_THAT(step({0, 0}), IsEmpty());
}

// Part 2 lies to the right of part 1, with its frame rotated by -90°: to the right is downwards there.
class OneWayBehindAnEdge : public testing::Test {
 protected:
  OneWayBehindAnEdge() { world.setRules(rules); }

  void build(const Segment& behind) {
    MapPart first(world, 1);
    first.warp({1000, -5000}, {1000, 5000}, 2, {-5000, -1000}, {5000, -1000});
    first.initialize();
    MapPart second(world, 2);
    second.line(behind.a, behind.b);
    second.warp({5000, -1000}, {-5000, -1000}, 1, {1000, 5000}, {1000, -5000});
    second.initialize();
    entity.emplace(world, square(100));
    MapPart(world, 1).insert(*entity, {700, 0}, Angle());
  }
  std::vector<std::string> step(Point velocity, Angle frame) {
    entity->setVelocity(velocity, frame);
    world.solve();
    return rules.take();
  }

  World world;
  OneWay rules;
  std::optional<Entity> entity;
};

TEST_F(OneWayBehindAnEdge, BlocksInTheFrameOfTheSegment) {
  build({{-4000, -1100}, {4000, -1100}});
  EXPECT_THAT(step({1000, 0}, Angle()), ElementsAre("begin 1:0", "begin 2:1", "contact 2:0", "over 1:0", "over 2:1"));
  EXPECT_EQ(entity->position(), Point(1000, 0));
}

TEST_F(OneWayBehindAnEdge, LetsThroughInTheFrameOfTheSegment) {
  build({{4000, -1100}, {-4000, -1100}});
  EXPECT_THAT(step({1000, 0}, Angle()),
              ElementsAre("begin 1:0", "begin 2:1", "begin 2:0", "end 1:0", "end 2:1", "end 2:0"));
  EXPECT_EQ(entity->part(), 2u);
  EXPECT_EQ(entity->position(), Point(0, -1700));
}

// The home part changes before the segment is reached. The state that `pierce` sees does not.
TEST_F(OneWayBehindAnEdge, BlocksAfterARehomeInTheSameStep) {
  build({{-4000, -2100}, {4000, -2100}});
  EXPECT_THAT(step({2000, 0}, Angle()),
              ElementsAre("begin 1:0", "begin 2:1", "end 1:0", "end 2:1", "contact 2:0", "contact 2:0"));
  EXPECT_EQ(entity->position(), Point(0, -2000));
  EXPECT_EQ(rules.contacts.at(0).segment.toHome, Angle()) << "in events, the home part is that after the step";
  EXPECT_EQ(rules.contacts.at(0).segment.instance, entity->state().id);
}

TEST_F(OneWayBehindAnEdge, LetsThroughAfterARehomeInTheSameStep) {
  build({{4000, -2100}, {-4000, -2100}});
  step({2000, 0}, Angle());
  EXPECT_EQ(entity->position(), Point(0, -2700));
  EXPECT_THAT(step({-2000, 0}, entity->heading()), ElementsAre("contact 2:0")) << "but not back";
  EXPECT_EQ(entity->position(), Point(0, -2200));
}

// Compares what `pierce` may read with the world before the step.
class Reading : public Rules {
 public:
  bool pierce(const Entity& entity, const SegmentRef& segment) const override {
    hashes.insert(entity.world().hash());
    for (std::uint32_t i = 0; i < entity.world().entities().size(); ++i) instances += entity.world().view(i).size();
    return segment.warp;
  }
  mutable std::set<std::uint64_t> hashes;
  mutable std::size_t instances = 0;
};

// Blocks bodies that are above it.
class Floor : public RecordedRules {
 public:
  bool pierce(const Entity&, const SegmentRef& segment) const override {
    return segment.warp || segment.position.y < segment.ends.a.y + 10;
  }
};

// The new instance would stand on the floor of the next part, or hang in it. Where the origin of the part is says
// nothing.
TEST(OneWayTest, AnInstanceThatAppearsIsAskedAboutWhereItWouldBe) {
  for (const std::int32_t height : {-400, 400}) {
    for (const std::int32_t above : {10, 4}) {
      World world = twoStrips({}, {{{-1300, height}, {-500, height}}});
      Floor rules;
      world.setRules(rules);
      Entity entity(world, square(10));
      MapPart(world, 1).insert(entity, {800, height + above}, Angle());
      entity.setVelocity({100, 0});
      for (int tick = 0; tick < 6; ++tick) world.solve();
      EXPECT_EQ(entity.part(), 2U) << height << ", " << above;
      entity.setVelocity({0, -5});
      world.solve();
      EXPECT_EQ(entity.position().y, height + (above == 10 ? 10 : above - 5));
    }
  }
}

TEST(PierceTest, SeesTheWorldBeforeTheStep) {
  World world = twoStrips({{{300, -100}, {300, 100}}}, {{{-800, -300}, {-800, 300}}});
  Entity first(world, square(100));
  Entity second(world, square(100));
  MapPart(world, 1).insert(first, {890, 0}, Angle());
  MapPart(world, 1).insert(second, {0, 0}, Angle());
  first.setVelocity({500, 3});
  second.setVelocity({500, 3});
  Reading rules;
  world.setRules(rules);
  const std::uint64_t before = world.hash();
  world.solve();
  EXPECT_EQ(rules.hashes, std::set{before});
  EXPECT_GT(rules.instances, 0u);
  EXPECT_NE(world.hash(), before);
}

TEST(PierceTest, ToHomeDoesNotDependOnTheRotationOfTheShape) {
  World world;
  addPart(world, 0, {{{-100, -60}, {100, -60}}});
  Entity entity(world, square(10));
  MapPart(world, 0).insert(entity, {0, 0}, Angle(3700));
  RecordedRules rules;
  world.setRules(rules);
  entity.rotate(1100);
  entity.setVelocity({0, -100});
  world.solve();
  ASSERT_FALSE(rules.contacts.empty());
  EXPECT_EQ(rules.contacts[0].segment.toHome, Angle());
}

// Throws at the call with this number.
class Throwing : public RecordedRules {
 public:
  bool pierce(const Entity&, const SegmentRef& segment) const override {
    if (asked++ == failing) throw std::runtime_error("pierce");
    return segment.warp;
  }
  mutable int asked = 0;
  int failing = 0;
};

TEST(PierceTest, AStepThatItThrowsInHasNoEffect) {
  World world = twoStrips({{{300, -100}, {300, 100}}}, {{{-800, -300}, {-800, 300}}});
  Entity first(world, square(100));
  Entity second(world, square(100));
  MapPart(world, 1).insert(first, {800, 0}, Angle());
  MapPart(world, 1).insert(second, {0, 0}, Angle());
  first.setVelocity({500, 3});
  second.setVelocity({500, 3});
  first.rotate(700);
  World expected = world;
  Throwing never;
  never.failing = -1;
  expected.setRules(never);
  expected.solve();
  ASSERT_GT(never.asked, 5);
  for (int failing = 0; failing < never.asked; ++failing) {
    World failed = world;
    Throwing rules;
    rules.failing = failing;
    failed.setRules(rules);
    EXPECT_THROW(failed.solve(), std::runtime_error);
    ASSERT_EQ(failed, world) << "call " << failing;
    failed.solve();
    ASSERT_EQ(failed, expected) << "call " << failing;
    ASSERT_EQ(rules.take(), never.calls) << "no event of the step that failed, call " << failing;
  }
}

// The entity stayed in the part.
TEST(PierceTest, AnInsertionThatItThrowsInHasNoEffect) {
  World world = twoStrips({{{600, -100}, {800, 200}}}, {{{-890, -300}, {-890, 300}}});
  RecordedRules open;
  open.pierceable = {{1, 0}, {2, 0}};
  Throwing rules;
  Entity entity(world, square(100));
  const World before = world;
  world.setRules(rules);
  for (rules.failing = 0; rules.failing < 2; ++rules.failing) {
    rules.asked = 0;
    EXPECT_THROW(MapPart(world, 1).insert(entity, {950, 150}, Angle()), std::runtime_error) << rules.failing;
    EXPECT_EQ(world, before) << rules.failing;
  }
  world.setRules(open);
  MapPart(world, 1).insert(entity, {950, 150}, Angle());
  EXPECT_EQ(world.view(0).size(), 2u);
}

// `insert` used the rules of setRules, `solve` those that were passed to it.
TEST(PierceTest, InsertAndSolveAskTheSameRules) {
  World world;
  addPart(world, 0, {{{0, -100}, {0, 100}}});
  Entity entity(world, square(10));
  RecordedRules rules;
  rules.pierceable = {{0, 0}};
  world.setRules(rules);
  MapPart(world, 0).insert(entity, {0, 0}, Angle());
  entity.setVelocity({3, 0});
  world.solve();
  EXPECT_EQ(entity.position(), Point(3, 0));
  world.resetRules();
  EXPECT_THROW(
      {
        world.erase(0);
        MapPart(world, 0).insert(entity, {0, 0}, Angle());
      },
      std::invalid_argument);
}

}  // namespace
}  // namespace platon::pierce_test
