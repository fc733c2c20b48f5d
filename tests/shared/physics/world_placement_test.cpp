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
  world.remove(0);
  EXPECT_THAT(rules.take(), ElementsAre("end 1:0", "end 1:1", "end 2:0"));
  world.remove(0);
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

// Contacts of an instance that has an id already given to another one would not be told apart.
TEST_F(WorldPlacementTest, AnEntityThatIsPlacedAgainHasNewIds) {
  const std::uint16_t id = entity.state().id;
  world.remove(0);
  MapPart(world, 1).insert(entity, {920, 0}, Angle());
  EXPECT_NE(entity.state().id, id);
}

}  // namespace
}  // namespace platon::world_placement_test
