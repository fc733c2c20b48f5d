// Insertion and removal of entities between steps.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "platon/physics/world.h"
#include "tests/shared/physics/maps.h"
#include "tests/shared/physics/recorded_rules.h"
#include "tests/shared/physics/refusal.h"
#include "tests/shared/physics/shapes.h"

namespace platon::world_placement_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// Two strips, and a door in the left one. A square of 200 by 200 stands in the door and reaches over the edge.
class WorldPlacementTest : public testing::Test {
 protected:
  WorldPlacementTest() : world(twoStrips({{{850, -5000}, {850, 5000}}})), entity(world, square(100)) {
    addPart(world, 3, {{{0, 0}, {100, 0}}});
    rules.pierceable = {{1, 0}};
    world.setRules(rules);
    MapPart(world, 1).insert(entity, {920, 0}, Angle());
    world.solve();
    EXPECT_THAT(rules.take(), ElementsAre("begin 1:0", "begin 1:1", "begin 2:0", "over 1:0", "over 1:1", "over 2:0"));
  }

  RecordedRules rules;
  World world;
  Entity entity;
};

TEST_F(WorldPlacementTest, RemovalEndsTheContactsOfAllInstances) {
  world.erase(0);
  EXPECT_THAT(rules.take(), ElementsAre("end 1:0", "end 1:1", "end 2:0"));
  world.erase(0);
  EXPECT_THAT(rules.take(), IsEmpty());
}

TEST_F(WorldPlacementTest, ErasingOnePartEndsTheContactsInIt) {
  MapPart(world, 2).erase(entity);
  EXPECT_THAT(rules.take(), ElementsAre("end 2:0"));
  world.solve();
  EXPECT_THAT(rules.take(), ElementsAre("begin 2:0", "over 1:0", "over 1:1", "over 2:0"));
}

// What the entity overlaps elsewhere is pierced until it is left.
TEST_F(WorldPlacementTest, AClosedDoorElsewhereDoesNotForbidAnotherInstance) {
  rules.pierceable = {{3, 0}};
  MapPart(world, 3).insert(entity, {50, 0}, Angle());
  EXPECT_THAT(rules.take(), IsEmpty());
  world.solve();
  EXPECT_THAT(rules.take(), ElementsAre("begin 3:0", "over 1:0", "over 1:1", "over 2:0", "over 3:0"));
  MapPart(world, 1).erase(entity);
  EXPECT_THAT(rules.take(), ElementsAre("end 1:0", "end 1:1", "end 2:0"));
  EXPECT_EQ(entity.part(), 3u);
  world.solve();
  EXPECT_THAT(rules.take(), ElementsAre("over 3:0"));
}

TEST_F(WorldPlacementTest, AClosedDoorForbidsTheInstanceThatIsPlaced) {
  rules.pierceable = {{1, 0}};
  const World before = world;
  EXPECT_THAT(refusal([&] {
                MapPart(world, 3).insert(entity, {50, 0}, Angle());
              }),
              HasSubstr("the shape overlaps a blocking segment"));
  EXPECT_EQ(world, before);
}

TEST_F(WorldPlacementTest, CanPlaceAnswersAsInsertDoes) {
  const World before = world;
  const MapPart free(world, 3);
  rules.pierceable = {};
  EXPECT_FALSE(free.canPlace(entity, {50, 0}, Angle()));
  EXPECT_TRUE(free.canPlace(entity, {50, 100}, Angle())) << "touching";
  EXPECT_FALSE(free.canPlace(entity, {50, 99}, Angle()));
  EXPECT_FALSE(free.canPlace(entity, {50, 100}, Angle::degrees(45)));
  rules.pierceable = {{3, 0}};
  EXPECT_TRUE(free.canPlace(entity, {50, 0}, Angle())) << "the rules let it pass";
  EXPECT_EQ(world, before);
  EXPECT_THAT(rules.take(), IsEmpty()) << "nothing is told";
  world.solve();
  EXPECT_THAT(rules.take(), ElementsAre("over 1:0", "over 1:1", "over 2:0")) << "the next step is not changed";
}

TEST_F(WorldPlacementTest, CanPlaceSeesBehindAnEdge) {
  World other = twoStrips({}, {{{-950, -5000}, {-950, 5000}}});
  Entity body(other, square(100));
  const MapPart left(other, 1);
  EXPECT_TRUE(left.canPlace(body, {900, 0}, Angle()));
  EXPECT_TRUE(left.canPlace(body, {950, 0}, Angle())) << "it touches the segment behind the edge";
  EXPECT_FALSE(left.canPlace(body, {960, 0}, Angle())) << "by more than an instance may be off";
  EXPECT_FALSE(left.canPlace(square(100), {960, 0}, Angle()));
  EXPECT_TRUE(left.canPlace(square(90), {960, 0}, Angle()));
}

// A body that is to return to its start is still where it is.
TEST_F(WorldPlacementTest, CanPlaceAnEntityAnewInItsPart) {
  rules.pierceable = {};
  EXPECT_TRUE(MapPart(world, 1).canPlace(entity, {0, 0}, Angle()));
  EXPECT_FALSE(MapPart(world, 1).canPlace(entity, {920, 0}, Angle())) << "the door is closed, and would be entered";
  class Frames : public Rules {
   public:
    bool pierce(const Entity&, const SegmentRef& segment) const override {
      toHome = segment.toHome;
      return true;
    }
    mutable Angle toHome{1};
  };
  Frames frames;
  world.setRules(frames);
  EXPECT_TRUE(MapPart(world, 1).canPlace(entity, {850, 0}, Angle::degrees(90)));
  EXPECT_EQ(frames.toHome, Angle()) << "it would be its home instance";
  EXPECT_EQ(entity.position(), Point(920, 0));
}

TEST_F(WorldPlacementTest, CanPlaceIsFalseWherePlacesAreImpossible) {
  constexpr std::int32_t kLimit = 1 << 29;
  const MapPart part(world, 3);
  EXPECT_FALSE(part.canPlace(entity, {kLimit, 0}, Angle()));
  EXPECT_FALSE(part.canPlace(square(10), {0, -kLimit}, Angle()));
  EXPECT_TRUE(part.canPlace(square(10), {0, 1 - kLimit}, Angle()));
  const Convex sliver(std::vector<Point>{{0, 0}, {3, 1}, {2, 1}});
  EXPECT_TRUE(part.canPlace(sliver, {0, 500}, Angle()));
  EXPECT_FALSE(part.canPlace(sliver, {0, 500}, Angle::degrees(20))) << "degenerate at this angle";
}

TEST_F(WorldPlacementTest, CanPlaceAShapeChangesNothing) {
  const World before = world;
  rules.pierceable = {};
  const MapPart part(world, 3);
  EXPECT_TRUE(part.canPlace(square(7), {50, 7}, Angle()));
  EXPECT_FALSE(part.canPlace(square(7), {50, 6}, Angle()));
  RecordedRules others;
  others.pierceable = {{3, 0}};
  EXPECT_TRUE(before.canPlace(3, square(7), {50, 6}, Angle(), others));
  EXPECT_THAT(others.take(), IsEmpty());
  EXPECT_EQ(world, before);
  EXPECT_EQ(world.entities().size(), 1u);
}

// The rules may look at the entity, also when there is only a shape yet.
TEST_F(WorldPlacementTest, CanPlaceAsksTheRulesWithAnEntityThatExists) {
  class Asking : public Rules {
   public:
    bool pierce(const Entity& asked, const SegmentRef&) const override {
      id = asked.id();
      return asked.exists() && asked.shape() == square(7) && asked.world().entities().size() == 2;
    }
    mutable EntityId id;
  };
  Asking asking;
  EXPECT_TRUE(world.canPlace(3, square(7), {50, 0}, Angle(), asking));
  EXPECT_EQ(asking.id, (EntityId{1, 0}));
}

TEST_F(WorldPlacementTest, CanPlaceRefusesWhatInsertRefusesOfTheCall) {
  const World before = world;
  World elsewhere = world;
  const std::string open = "map part 9 is not initialised: call MapPart::initialize before canPlace()";
  EXPECT_EQ(refusal([&] { (void)MapPart(world, 9).canPlace(entity, {0, 0}, Angle()); }), open);
  EXPECT_EQ(refusal([&] { (void)MapPart(world, 9).canPlace(square(3), {0, 0}, Angle()); }), open);
  EXPECT_EQ(refusal([&] {
              (void)MapPart(world, 3).canPlace(Entity(world, 1), {0, 0}, Angle());
            }),
            "entity 1 does not exist: the world has 1 entities, counted from 0");
  EXPECT_EQ(refusal([&] {
              (void)MapPart(elsewhere, 3).canPlace(entity, {0, 0}, Angle());
            }),
            "map part 3: entity 0 belongs to another world: use an entity of the world of this part");
  EXPECT_EQ(world, before);
}

// Contacts of an instance that has an id already given to another one would not be told apart.
TEST_F(WorldPlacementTest, AnEntityThatIsPlacedAgainHasNewIds) {
  const std::uint16_t id = entity.state().id;
  world.erase(0);
  MapPart(world, 1).insert(entity, {920, 0}, Angle());
  EXPECT_NE(entity.state().id, id);
}

}  // namespace
}  // namespace platon::world_placement_test
