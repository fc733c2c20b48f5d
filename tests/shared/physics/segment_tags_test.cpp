#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "platon/physics/map_part.h"
#include "platon/physics/world.h"
#include "tests/shared/physics/maps.h"
#include "tests/shared/physics/shapes.h"

namespace platon::segment_tags_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// Records the tag of the segment of every call.
class Tags : public Rules {
 public:
  explicit Tags(std::uint32_t passed) : passed_(passed) {}
  bool pierce(const Entity&, const SegmentRef& segment) const override {
    if (!segment.warp) asked.insert(segment.tag);
    return segment.warp || segment.tag == passed_;
  }
  void beginContact(Entity&, const SegmentRef& segment) override { note("begin", segment); }
  void overContact(Entity&, const SegmentRef& segment) override { note("over", segment); }
  void endContact(Entity&, const SegmentRef& segment) override { note("end", segment); }
  void contact(Entity&, const Contact& contact) override { note("contact", contact.segment); }
  void touchContact(Entity&, const SegmentRef& segment) override { note("touch", segment); }

  std::vector<std::string> calls;
  mutable std::set<std::uint32_t> asked;

 private:
  void note(const char* what, const SegmentRef& segment) {
    calls.push_back(std::string(what) + " " + std::to_string(segment.index) + " tag " + std::to_string(segment.tag));
  }
  std::uint32_t passed_;
};

// A floor without a tag at y = -10, doors with the tags 7 and 8 at x = 100 and 200, and a square of 20 by 20.
class SegmentTagsTest : public testing::Test {
 protected:
  SegmentTagsTest() : entity(make()) {}

  Entity make() {
    MapPart part(world, 3);
    part.line({-1000, -10}, {1000, -10});
    part.line({100, -1000}, {100, 1000}, 7);
    part.line({200, -1000}, {200, 1000}, 8);
    part.initialize();
    Entity made(world, square(10));
    part.insert(made, {0, 0}, Angle());
    return made;
  }
  std::vector<std::string> step(Tags& rules, Point velocity) {
    world.setRules(rules);
    entity.setVelocity(velocity);
    world.solve();
    return std::exchange(rules.calls, {});
  }

  World world;
  Entity entity;
};

TEST_F(SegmentTagsTest, EveryCallHasTheTag) {
  Tags rules(7);
  EXPECT_THAT(step(rules, {100, 0}), ElementsAre("begin 1 tag 7", "over 1 tag 7"));
  EXPECT_THAT(step(rules, {100, 0}), ElementsAre("end 1 tag 7", "contact 2 tag 8"));
  EXPECT_EQ(entity.position(), Point(190, 0));
  EXPECT_THAT(rules.asked, ElementsAre(7, 8));
  entity.rotate(1000);
  EXPECT_THAT(step(rules, {0, 0}), ElementsAre("touch 0 tag 0"));
  EXPECT_THAT(rules.asked, ElementsAre(0, 7, 8));
}

TEST_F(SegmentTagsTest, InsertionAndRemovalHaveTheTag) {
  Tags rules(7);
  world.setRules(rules);
  MapPart part(world, 3);
  part.erase(entity);
  part.insert(entity, {100, 100}, Angle());
  EXPECT_THAT(rules.asked, ElementsAre(7)) << "it could be inserted, since its tag lets it pass";
  world.solve();
  rules.calls.clear();
  part.erase(entity);
  EXPECT_THAT(rules.calls, ElementsAre("end 1 tag 7"));
}

TEST_F(SegmentTagsTest, AnEntityAtRestGetsTheTagAgain) {
  Tags rules(7);
  entity.setVelocity({0, 0});
  MapPart part(world, 3);
  part.erase(entity);
  part.insert(entity, {190, 100}, Angle());
  for (int tick = 0; tick < 3; ++tick) EXPECT_THAT(step(rules, {5, 0}), ElementsAre("contact 2 tag 8")) << tick;
}

TEST_F(SegmentTagsTest, ACallbackMayAddAPartWithTags) {
  class Adding : public Tags {
   public:
    Adding() : Tags(7) {}
    void beginContact(Entity& entity, const SegmentRef& segment) override {
      Tags::beginContact(entity, segment);
      MapPart part(entity.world(), 9);
      part.line({0, 0}, {1, 1}, 5);
      part.initialize();
    }
  };
  Adding rules;
  EXPECT_THAT(step(rules, {100, 0}), ElementsAre("begin 1 tag 7", "over 1 tag 7"));
  EXPECT_EQ(world.geometry().find(9)->tagOf(0), 5u);
}

// Tags are of the geometry: they are in no state, and a world with them moves as one without.
TEST(SegmentTagsStateTest, TagsDoNotChangeTheState) {
  const auto worldWith = [](std::uint32_t tag) {
    World world;
    MapPart part(world, 1);
    part.line({100, -100}, {100, 100}, tag);
    part.initialize();
    Entity entity(world, square(10));
    part.insert(entity, {0, 0}, Angle());
    entity.setVelocity({95, 3});
    world.solve();
    return world;
  };
  EXPECT_EQ(worldWith(0).save(), worldWith(4).save());
  EXPECT_EQ(worldWith(0).hash(), worldWith(4).hash());
  EXPECT_EQ(worldWith(4), worldWith(4));
  EXPECT_FALSE(worldWith(0) == worldWith(4));
  EXPECT_FALSE(worldWith(5) == worldWith(4));
}

}  // namespace
}  // namespace platon::segment_tags_test
