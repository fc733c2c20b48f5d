#include "platon/physics/rules.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "platon/physics/world.h"
#include "tests/shared/physics/maps.h"
#include "tests/shared/physics/recorded_rules.h"
#include "tests/shared/physics/shapes.h"

namespace platon::rules_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// One part with id 0 and a square of 20 by 20 in it.
class RulesTest : public testing::Test {
 protected:
  void build(const std::vector<Segment>& lines, Point at, Angle angle = {}) {
    addPart(world, 0, lines);
    entity.emplace(world, square(10));
    MapPart(world, 0).insert(*entity, at, angle);
  }
  std::vector<std::string> step(Point velocity) {
    entity->setVelocity(velocity);
    world.setRules(rules);
    world.solve();
    return rules.take();
  }

  World world;
  RecordedRules rules;
  std::optional<Entity> entity;
};

TEST_F(RulesTest, SegmentsBlockAndWarpsDoNotByDefault) {
  build({{{-100, 0}, {100, 0}}}, {0, 50});
  const Rules plain;
  EXPECT_FALSE(plain.pierce(*entity, SegmentRef{0, 0, false, {}}));
  EXPECT_TRUE(plain.pierce(*entity, SegmentRef{0, 0, true, {}}));
}

TEST_F(RulesTest, ContactDescribesTheCollision) {
  build({{{-100, -20}, {100, -20}}}, {0, 0});
  EXPECT_THAT(step({0, -30}), ElementsAre("contact 0:0"));
  EXPECT_EQ(entity->position(), Point(0, -10));
  const Contact& contact = rules.contacts.at(0);
  EXPECT_EQ(contact.time, (Fraction{1, 3}));
  EXPECT_EQ(contact.normal.x, 0);
  EXPECT_GT(contact.normal.y, 0);
  EXPECT_EQ(contact.point.y, -20);
  EXPECT_LE(std::abs(contact.point.x), 10);
  EXPECT_EQ(contact.segment.instance, 0);
  EXPECT_EQ(contact.segment.toHome, Angle());
  EXPECT_EQ(contact.segment.ends, (Segment{{-100, -20}, {100, -20}}));
  EXPECT_FALSE(contact.segment.warp);
}

TEST_F(RulesTest, PressingCallsContactInEveryTick) {
  build({{{-100, -10}, {100, -10}}}, {0, 0});
  for (int tick = 0; tick < 5; ++tick) {
    EXPECT_THAT(step({0, -1}), ElementsAre("contact 0:0"));
    EXPECT_EQ(rules.contacts.back().time, (Fraction{0, 1}));
  }
  EXPECT_THAT(step({5, 0}), IsEmpty()) << "sliding along is not a contact";
  EXPECT_THAT(step({0, 5}), IsEmpty());
}

TEST_F(RulesTest, ContactPointOfASegmentEndIsTheEnd) {
  build({{{3, -20}, {3, -90}}}, {0, 0});
  EXPECT_THAT(step({0, -40}), ElementsAre("contact 0:0"));
  EXPECT_EQ(rules.contacts.at(0).point, Point(3, -20));
  EXPECT_EQ(rules.contacts.at(0).normal.x, 0);
  EXPECT_GT(rules.contacts.at(0).normal.y, 0);
}

TEST_F(RulesTest, ContactPointIsOnTheSegment) {
  build({{{4, -20}, {7, -20}}}, {0, 0});
  EXPECT_THAT(step({0, -40}), ElementsAre("contact 0:0"));
  EXPECT_EQ(rules.contacts.at(0).point.y, -20);
  EXPECT_GE(rules.contacts.at(0).point.x, 4);
  EXPECT_LE(rules.contacts.at(0).point.x, 7);
}

TEST_F(RulesTest, ContactNormalOnASlopeIsExact) {
  build({{{-300, -300}, {300, 0}}}, {0, 0});
  EXPECT_THAT(step({0, -500}), ElementsAre("contact 0:0"));
  const Point normal = rules.contacts.at(0).normal;
  EXPECT_EQ(dot(normal, Point(2, 1)), 0);
  EXPECT_GT(normal.y, 0);
  // The lower right vertex meets y = x / 2 - 150 at x = 10.
  EXPECT_LE(squaredLength(rules.contacts.at(0).point - Point(10, -145)), 2);
}

TEST_F(RulesTest, PierceableSegmentsCallBeginOverAndEnd) {
  build({{{-100, -15}, {100, -15}}}, {0, 0});
  rules.pierceable = {{0, 0}};
  EXPECT_THAT(step({0, -5}), IsEmpty()) << "touching is not a contact";
  EXPECT_THAT(step({0, -5}), ElementsAre("begin 0:0", "over 0:0"));
  EXPECT_THAT(step({0, 0}), ElementsAre("over 0:0"));
  EXPECT_THAT(step({3, -5}), ElementsAre("over 0:0"));
  EXPECT_THAT(step({0, -9}), ElementsAre("over 0:0"));
  EXPECT_THAT(step({0, -2}), ElementsAre("end 0:0"));
  EXPECT_THAT(step({0, -5}), IsEmpty());
  EXPECT_EQ(entity->position(), Point(3, -31));
}

TEST_F(RulesTest, EndContactIsCalledAtTheEndOfTheTick) {
  build({{{-100, -15}, {100, -15}}}, {0, 0});
  rules.pierceable = {{0, 0}};
  EXPECT_THAT(step({0, -15}), ElementsAre("begin 0:0", "over 0:0"));
  EXPECT_THAT(step({0, -10}), ElementsAre("end 0:0")) << "it touches the line from below now";
  EXPECT_THAT(step({0, -10}), IsEmpty());
  EXPECT_THAT(step({0, 11}), ElementsAre("begin 0:0", "over 0:0"));
  EXPECT_THAT(step({0, 19}), ElementsAre("end 0:0"));
}

TEST_F(RulesTest, BeginAndEndMayOccurInOneLeg) {
  build({{{0, -15}, {1, -15}}, {{-3, -200}, {-3, -200}}}, {0, 0});
  rules.pierceable = {{0, 0}, {0, 1}};
  EXPECT_THAT(step({0, -100}), ElementsAre("begin 0:0", "end 0:0"));
  EXPECT_THAT(step({0, -200}), ElementsAre("begin 0:1", "end 0:1")) << "a point";
  EXPECT_EQ(entity->position(), Point(0, -300));
}

TEST_F(RulesTest, EventsAreOrderedByTime) {
  build({{{-100, -60}, {100, -60}}, {{-100, -15}, {100, -15}}, {{-100, -25}, {100, -25}}}, {0, 0});
  rules.pierceable = {{0, 0}, {0, 1}, {0, 2}};
  EXPECT_THAT(step({0, -65}), ElementsAre("begin 0:1", "begin 0:2", "end 0:1", "end 0:2", "begin 0:0", "over 0:0"));
}

TEST_F(RulesTest, SimultaneousEventsAreOrderedByIndex) {
  build({{{-100, -15}, {-5, -15}}, {{5, -15}, {100, -15}}, {{-100, 0}, {100, 0}}}, {0, 30});
  rules.pierceable = {{0, 0}, {0, 1}, {0, 2}};
  EXPECT_THAT(step({0, -40}), ElementsAre("begin 0:2", "begin 0:0", "begin 0:1", "end 0:2", "over 0:0", "over 0:1"));
  EXPECT_THAT(step({1, 0}), ElementsAre("over 0:0", "over 0:1"));
}

TEST_F(RulesTest, PiercedSegmentsPrecedeTheContactOfTheLeg) {
  build({{{-100, -40}, {100, -40}}, {{-100, -15}, {100, -15}}, {{-100, -35}, {100, -35}}, {{-100, -45}, {100, -45}}},
        {0, 0});
  rules.pierceable = {{0, 1}, {0, 2}, {0, 3}};
  EXPECT_THAT(step({0, -90}), ElementsAre("begin 0:1", "end 0:1", "begin 0:2", "contact 0:0", "over 0:2"))
      << "segment 3 is behind the wall";
}

TEST_F(RulesTest, AContactThatEndsWithTheLegPrecedesTheContactOfTheLeg) {
  build({{{-100, -15}, {100, -15}}, {{-100, -35}, {100, -35}}}, {0, 0});
  rules.pierceable = {{0, 0}};
  EXPECT_THAT(step({0, -40}), ElementsAre("begin 0:0", "end 0:0", "contact 0:1"));
}

TEST_F(RulesTest, EventsOfASlideFollowTheContact) {
  build({{{-500, -20}, {500, -20}}, {{15, -500}, {15, 500}}}, {0, 0});
  rules.pierceable = {{0, 1}};
  EXPECT_THAT(step({3, -20}), ElementsAre("contact 0:0"));
  EXPECT_THAT(step({40, -20}), ElementsAre("contact 0:0", "begin 0:1", "end 0:1"));
}

TEST_F(RulesTest, BeginIsCalledOnceAfterInsertion) {
  rules.pierceable = {{0, 0}};
  world.setRules(rules);
  build({{{-100, 0}, {100, 0}}}, {0, 0});
  EXPECT_THAT(step({0, 0}), ElementsAre("begin 0:0", "over 0:0"));
  EXPECT_THAT(step({0, 0}), ElementsAre("over 0:0"));
  EXPECT_THAT(step({0, 30}), ElementsAre("end 0:0"));
}

TEST_F(RulesTest, PierceIsCalledForSegmentsOnThePathOnly) {
  class Asking : public Rules {
   public:
    bool pierce(const Entity&, const SegmentRef& segment) const override {
      asked.insert(segment.index);
      return false;
    }
    mutable std::set<std::uint32_t> asked;
  };
  build({{{-100, -20}, {100, -20}}, {{-100, 20}, {100, 20}}, {{40, -5}, {40, 5}}}, {0, 0});
  Asking asking;
  entity->setVelocity({0, -30});
  world.setRules(asking);
  world.solve();
  EXPECT_EQ(asking.asked, (std::set<std::uint32_t>{0}));
}

TEST_F(RulesTest, RulesMayChangeTheVelocityOfTheNextStep) {
  class Bouncing : public Rules {
   public:
    void contact(Entity& entity, const Contact&) override { entity.setVelocity({0, 7}); }
  };
  build({{{-100, -20}, {100, -20}}}, {0, 0});
  Bouncing bouncing;
  entity->setVelocity({0, -30});
  world.setRules(bouncing);
  world.solve();
  EXPECT_EQ(entity->position(), Point(0, -10));
  world.setRules(bouncing);
  world.solve();
  EXPECT_EQ(entity->position(), Point(0, -3));
}

TEST_F(RulesTest, SolveUsesTheRulesOfSetRules) {
  build({{{-100, -20}, {100, -20}}}, {0, 0});
  world.setRules(rules);
  entity->setVelocity({0, -30});
  world.solve();
  EXPECT_THAT(rules.take(), ElementsAre("contact 0:0"));
}

TEST_F(RulesTest, RotationStopsAtTheLastFreeAngle) {
  build({{{12, -100}, {12, 100}}}, {0, 0});
  entity->rotate(4500);
  world.setRules(rules);
  world.solve();
  EXPECT_THAT(rules.take(), ElementsAre("touch 0:0"));
  const std::int32_t stopped = entity->rotation().centidegrees();
  // Half of the diagonal of the square is 14.14 subunits; a vertex reaches x = 12 between 13° and 14°.
  EXPECT_GT(stopped, 0);
  EXPECT_LT(stopped, 4500);
  const auto reach = [&](std::int32_t angle) { return square(10).turned(Angle(angle))->bounds().high.x; };
  EXPECT_LE(reach(stopped), 12);
  EXPECT_GT(reach(stopped + 1), 12) << "one more centidegree would overlap";
}

TEST_F(RulesTest, RotationStopsAtTheLastFreeAngleInBothDirections) {
  addPart(world, 0, {{{11500, -30000}, {11500, 30000}}});
  Entity large(world, square(10000));
  MapPart(world, 0).insert(large, {0, 0}, Angle());
  const auto reach = [&](std::int32_t angle) { return square(10000).turned(Angle(angle))->bounds().high.x; };
  for (const std::int32_t turn : {4500, -4500, 35999, -35999}) {
    World copy = world;
    Entity turning(copy, 0);
    turning.rotate(turn);
    copy.setRules(rules);
    copy.solve();
    EXPECT_THAT(rules.take(), ElementsAre("touch 0:0"));
    const std::int32_t stopped = turning.rotation().centidegrees();
    EXPECT_LE(reach(stopped), 11500);
    EXPECT_GT(reach(stopped + (turn > 0 ? 1 : -1)), 11500) << "from " << turn;
    copy.setRules(rules);
    copy.solve();
    EXPECT_THAT(rules.take(), IsEmpty()) << "a rotation is requested for one step";
    EXPECT_EQ(turning.rotation().centidegrees(), stopped);
  }
}

TEST_F(RulesTest, FreeRotationsAreExact) {
  build({{{20, -100}, {20, 100}}}, {0, 0});
  std::int32_t expected = 0;
  for (const std::int32_t turn : {1, 499, 500, 501, 9000, -17, 35999, -35999}) {
    entity->rotate(turn);
    world.setRules(rules);
    world.solve();
    expected += turn;
    EXPECT_EQ(entity->rotation(), Angle(expected));
    EXPECT_EQ(entity->position(), Point(0, 0));
  }
  EXPECT_THAT(rules.take(), IsEmpty());
}

TEST_F(RulesTest, RotationsCallBeginAndEnd) {
  build({{{12, -100}, {12, 100}}, {{-100, -12}, {100, -12}}}, {0, 0});
  rules.pierceable = {{0, 0}, {0, 1}};
  const auto turn = [&](std::int32_t centidegrees) {
    entity->rotate(centidegrees);
    world.setRules(rules);
    world.solve();
    return rules.take();
  };
  EXPECT_THAT(turn(500), IsEmpty()) << "its vertices reach 11 subunits";
  EXPECT_THAT(turn(4000), ElementsAre("begin 0:0", "begin 0:1", "over 0:0", "over 0:1"));
  EXPECT_THAT(turn(0), ElementsAre("over 0:0", "over 0:1"));
  EXPECT_THAT(turn(500), ElementsAre("over 0:0", "over 0:1"));
  EXPECT_THAT(turn(4000), ElementsAre("end 0:0", "end 0:1"));
  EXPECT_THAT(turn(9000), ElementsAre("begin 0:0", "begin 0:1", "end 0:0", "end 0:1"));
  EXPECT_EQ(entity->rotation(), Angle(18000));
}

TEST_F(RulesTest, RotationAfterInsertionCallsBeginOnce) {
  rules.pierceable = {{0, 0}};
  world.setRules(rules);
  build({{{0, -100}, {0, 100}}}, {0, 0});
  entity->rotate(1000);
  EXPECT_THAT(step({1, 0}), ElementsAre("begin 0:0", "over 0:0"));
  EXPECT_THAT(step({1, 0}), ElementsAre("over 0:0"));
}

TEST_F(RulesTest, TheLowestIndexWinsAtEqualTimes) {
  build({{{-100, -30}, {100, -30}}, {{-100, -20}, {0, -20}}, {{-5, -20}, {100, -20}}}, {0, 0});
  EXPECT_THAT(step({0, -30}), ElementsAre("contact 0:1"));
}

class WarpRulesTest : public testing::Test {
 protected:
  WarpRulesTest() : world(twoStrips()), entity(world, square(100)) {
    MapPart(world, 1).insert(entity, {800, 0}, Angle());
  }

  std::vector<std::string> step(Point velocity) {
    entity.setVelocity(velocity);
    world.setRules(rules);
    world.solve();
    return rules.take();
  }

  World world;
  RecordedRules rules;
  Entity entity;
};

TEST_F(WarpRulesTest, BothInstancesReportTheirWarps) {
  EXPECT_THAT(step({100, 0}), IsEmpty()) << "touching";
  EXPECT_THAT(step({50, 0}), ElementsAre("begin 1:0", "begin 2:0", "over 1:0", "over 2:0"));
  EXPECT_THAT(step({0, 0}), ElementsAre("over 1:0", "over 2:0"));
  EXPECT_EQ(entity.part(), 1u);
  EXPECT_THAT(step({100, 0}), ElementsAre("over 2:0", "over 1:0")) << "the home instance has changed";
  EXPECT_EQ(entity.part(), 2u);
  EXPECT_EQ(entity.position(), Point(-950, 0));
  EXPECT_THAT(step({60, 0}), ElementsAre("end 2:0", "end 1:0"));
  EXPECT_THAT(step({60, 0}), IsEmpty());
  EXPECT_EQ(world.view(0).size(), 1u);
}

TEST_F(WarpRulesTest, WarpsCrossedInOneTickBeginAndEnd) {
  EXPECT_THAT(step({700, 0}), ElementsAre("begin 1:0", "begin 2:0", "end 1:0", "end 2:0"));
  EXPECT_EQ(entity.part(), 2u);
  EXPECT_EQ(entity.position(), Point(-500, 0));
}

TEST_F(WarpRulesTest, WarpsThatAreNotPierceableBlock) {
  rules.walls = {{1, 0}};
  EXPECT_THAT(step({700, 0}), ElementsAre("contact 1:0"));
  EXPECT_EQ(entity.part(), 1u);
  EXPECT_EQ(entity.position(), Point(900, 0));
  EXPECT_TRUE(rules.contacts.at(0).segment.warp);
  EXPECT_EQ(world.view(0).size(), 1u);
  EXPECT_THAT(step({700, 30}), ElementsAre("contact 1:0"));
  EXPECT_EQ(entity.position(), Point(900, 30)) << "it slides along";
}

TEST(WarpContactTest, ASegmentBehindTheEdgeStopsBothInstances) {
  World world = twoStrips({}, {{{-900, -5000}, {-900, 5000}}});
  RecordedRules rules;
  Entity entity(world, square(100));
  MapPart(world, 1).insert(entity, {700, 0}, Angle());
  entity.setVelocity({1000, 0});
  world.setRules(rules);
  world.solve();
  EXPECT_THAT(rules.take(), ElementsAre("begin 1:0", "begin 2:1", "contact 2:0", "over 1:0", "over 2:1"));
  EXPECT_EQ(entity.part(), 1u);
  EXPECT_EQ(entity.position(), Point(1000, 0)) << "the centre is on the edge";
  const Contact& contact = rules.contacts.at(0);
  EXPECT_EQ(contact.time, (Fraction{3, 10}));
  EXPECT_EQ(contact.point.x, -900);
  EXPECT_LT(contact.normal.x, 0);
  EXPECT_NE(contact.segment.instance, entity.state().id);
}

TEST(WarpContactTest, ToHomeIsTheAngleBetweenTheParts) {
  World world;
  MapPart first(world, 1);
  first.warp({1000, -5000}, {1000, 5000}, 2, {-5000, -1000}, {5000, -1000});
  first.initialize();
  MapPart second(world, 2);
  second.line({-5000, -1100}, {5000, -1100});
  second.warp({5000, -1000}, {-5000, -1000}, 1, {1000, 5000}, {1000, -5000});
  second.initialize();
  RecordedRules rules;
  Entity entity(world, square(100));
  MapPart(world, 1).insert(entity, {700, 0}, Angle());
  entity.setVelocity({1000, 0});
  world.setRules(rules);
  world.solve();
  ASSERT_EQ(rules.contacts.size(), 1u);
  EXPECT_EQ(rules.contacts[0].segment.toHome, Angle::degrees(90));
  EXPECT_GT(rules.contacts[0].normal.y, 0);
  EXPECT_EQ(rules.contacts[0].normal.x, 0);
  EXPECT_EQ(rules.contacts[0].point.y, -1100);
  EXPECT_EQ(entity.position(), Point(1000, 0));
}

}  // namespace
}  // namespace platon::rules_test
