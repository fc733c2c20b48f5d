// The code examples of the report on the program with which this engine began, with the world as an argument where the
// report had one world for the whole program. The names are those of the report, so that such code still compiles.
#include <gtest/gtest.h>

#include <vector>

#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "platon/physics/rules.h"
#include "platon/physics/world.h"

using platon::Angle;
using platon::Contact;
using platon::Entity;
using platon::MapPart;
using platon::Point;
using platon::Rules;
using platon::SegmentRef;
using platon::World;
namespace intern = platon::intern;

namespace report_examples_test {
namespace {

TEST(ReportExamplesTest, AnEntity) {
  World world;

  intern::Convex shape;
  shape.vertices.push_back(Point(0, 0));
  shape.vertices.push_back(Point(10, 0));
  shape.vertices.push_back(Point(10, 10));
  shape.vertices.push_back(Point(0, 10));
  Entity entity(world, shape);

  EXPECT_EQ(entity.shape().vertices(), shape.vertices);
  EXPECT_EQ(world.entities().size(), 1u);
  EXPECT_FALSE(entity.inserted());
  entity.setVelocity(Point(3, -4));
  EXPECT_EQ(entity.velocity(), Point(3, -4));
}

TEST(ReportExamplesTest, AMapPartition) {
  World world;

  MapPart face(world, 12345);  // our unique id
  face.line(Point(0, 0), Point(-50, 20));
  face.line(Point(-50, 20), Point(100, 80));
  face.initialize();

  const platon::MapGeometry* part = world.geometry().find(12345);
  ASSERT_NE(part, nullptr);
  EXPECT_EQ(part->segments, (std::vector<platon::Segment>{{{0, 0}, {-50, 20}}, {{-50, 20}, {100, 80}}}));
  EXPECT_TRUE(part->warps.empty());
  EXPECT_EQ(face.id(), 12345u);
}

TEST(ReportExamplesTest, TheEntityMovesInTheMapPartition) {
  World world;
  MapPart face(world, 12345);
  face.line(Point(0, 0), Point(-50, 20));
  face.line(Point(-50, 20), Point(100, 80));
  face.initialize();
  intern::Convex shape;
  shape.vertices = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  Entity entity(world, shape);
  face.insert(entity, Point(-45, 60), Angle());
  Rules rules;
  world.setRules(rules);
  entity.setVelocity(Point(0, -34));
  world.solve();
  EXPECT_EQ(entity.position(), Point(-45, 26));
  // It touches the second segment, y = 20 + (x + 50) * 2 / 5, with its lower right vertex at x = -35.
  entity.setVelocity(Point(0, -1));
  world.solve();
  EXPECT_EQ(entity.position(), Point(-45, 26));
  face.erase(entity);
  EXPECT_FALSE(entity.inserted());
}

// Counts the calls of the methods that the report names.
class CountingRules : public Rules {
 public:
  int contacts = 0;
  int begins = 0;
  int overs = 0;
  int ends = 0;
  mutable int asked = 0;

  bool pierce(const Entity& entity, const SegmentRef& segment) const override {
    ++asked;
    return Rules::pierce(entity, segment);
  }
  void beginContact(Entity&, const SegmentRef&) override { ++begins; }
  void overContact(Entity&, const SegmentRef&) override { ++overs; }
  void endContact(Entity&, const SegmentRef&) override { ++ends; }
  void contact(Entity&, const Contact&) override { ++contacts; }
  void touchContact(Entity&, const SegmentRef&) override {}
};

// The report's insert, erase, warp, World::solve and World::setRules: an entity crosses a warp and hits a wall behind
// it.
TEST(ReportExamplesTest, AWorldWithRulesAndAWarp) {
  World world;
  MapPart left(world, 1);
  left.warp(Point(100, -500), Point(100, 500), 2, Point(0, -500), Point(0, 500));
  left.initialize();
  MapPart right(world, 2);
  right.line(Point(70, -500), Point(70, 500));
  right.warp(Point(0, 500), Point(0, -500), 1, Point(100, 500), Point(100, -500));
  right.initialize();
  CountingRules rules;
  world.setRules(rules);

  intern::Convex shape;
  shape.vertices = {Point(0, 0), Point(10, 0), Point(10, 10), Point(0, 10)};
  Entity character(world, shape);
  left.insert(character, Point(20, 0), Angle());
  character.setVelocity(Point(9, 0));
  for (int frame = 0; frame < 24; ++frame) world.solve();

  EXPECT_EQ(character.part(), 2u);
  EXPECT_EQ(character.position(), Point(60, 0)) << "the wall is at 70, the shape is 10 wide";
  EXPECT_GT(rules.asked, 0);
  EXPECT_GT(rules.contacts, 0);
  EXPECT_GT(rules.begins, 0);
  EXPECT_GT(rules.overs, 0);
  EXPECT_GT(rules.ends, 0);
  right.erase(character);
  EXPECT_FALSE(character.inserted());
}

}  // namespace
}  // namespace report_examples_test
