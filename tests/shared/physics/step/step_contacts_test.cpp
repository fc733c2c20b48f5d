// beginContact and endContact alternate for each entity, instance and segment, whatever happens to them.
#include <gtest/gtest.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "platon/physics/sweep.h"
#include "platon/physics/world.h"
#include "tests/shared/physics/maps.h"
#include "tests/shared/physics/recorded_rules.h"
#include "tests/shared/physics/shapes.h"
#include "tests/shared/physics/step/paired_rules.h"
#include "tests/shared/physics/torus.h"
#include "tests/sim/seeded_random.h"

namespace platon::step_contacts_test {
namespace {

using Contacts = PairedRules::Contacts;

// The pierced segments that instances overlap: all that they overlap. Those of fresh instances have not begun.
Contacts overlapsOf(const World& world, bool withFresh = false) {
  Contacts overlaps;
  for (std::uint32_t entity = 0; entity < world.entities().size(); ++entity) {
    const auto further = world.instancesOf(entity);
    std::size_t next = 0;
    for (const InstanceView& view : world.view(entity)) {
      const bool isFresh = (view.home ? world.entities()[entity].fresh : further[next++].fresh) != 0;
      if (isFresh && !withFresh) continue;
      Sweep sweep;
      const Convex shape = *world.shapeOf(entity).turned(view.angle);
      sweep.start(shape, view.position, {});
      const MapGeometry& part = *world.geometry().find(view.part);
      for (std::uint32_t segment = 0; segment < part.segments.size(); ++segment) {
        if (sweep.against(part.segments[segment])) overlaps.insert({entity, view.id, view.part, segment});
      }
    }
  }
  return overlaps;
}

// Segments by their index: walls, doors that open and close, and segments that block from one side.
class AllKinds : public PairedRules {
 public:
  explicit AllKinds(std::uint64_t seed) : random_(seed) {}

  bool pierce(const Entity& entity, const SegmentRef& segment) const override {
    if (segment.warp) return segment.index != kTorusSegments || isOpen[segment.part % 4];
    if (segment.index % 3 == 0) return false;
    if (segment.index % 3 == 1) return isOpen[segment.index % 4];
    return cross(segment.ends.b - segment.ends.a, rotate(entity.velocity(), -segment.toHome)) > 0;
  }
  void beginContact(Entity& entity, const SegmentRef& segment) override {
    PairedRules::beginContact(entity, segment);
    interfere(entity);
  }
  void endContact(Entity& entity, const SegmentRef& segment) override {
    PairedRules::endContact(entity, segment);
    interfere(entity);
  }
  void contact(Entity& entity, const Contact&) override { interfere(entity); }

  bool isOpen[4] = {true, true, true, true};

 private:
  // Changes the world from inside of a callback.
  void interfere(Entity& entity) {
    World& world = entity.world();
    const auto part = static_cast<std::uint32_t>(random_.below(kTorusParts));
    switch (random_.below(60)) {
      case 0:
        return world.erase(entity.index());
      case 1:
        return MapPart(world, part).erase(entity);
      case 2:
        return entity.rotate(1500);
      case 3:
        return entity.setVelocity(random_.vector(300));
      case 4:
        return insert(world, part);
      default:
        return;
    }
  }
  // An entity that is in no part, or a new one.
  void insert(World& world, std::uint32_t part) {
    for (std::uint32_t index = 0; index < world.entities().size(); ++index) {
      if (Entity(world, index).inserted()) continue;
      Entity entity(world, index);
      return tryToInsert(entity, part);
    }
    if (world.entities().size() >= 8) return;
    Entity entity(world, square(50));
    tryToInsert(entity, part);
  }
  void tryToInsert(Entity& entity, std::uint32_t part) {
    try {
      MapPart(entity.world(), part).insert(entity, random_.vector(kTorusReach), Angle());
    } catch (const std::invalid_argument&) {  // not free there
    }
  }

  sim::SeededRandom random_;
};

class ContactPairsTest : public testing::TestWithParam<std::uint64_t> {
 protected:
  ContactPairsTest() : random_(GetParam()), rules_(GetParam()) {
    world_.setRules(rules_);
    for (std::uint32_t part = 0; part + 1 < kTorusParts; ++part) addTorusPart(world_, part, random_);
    for (int i = 0; i < 6; ++i) put(Entity(world_, i % 2 == 0 ? square(60) : randomConvex(random_, 150)));
    saved_ = world_.save();
  }

  bool oneIn(std::uint64_t times) { return random_.below(times) == 0; }
  void put(Entity entity) {
    try {
      const Point origin = random_.vector(kTorusReach);
      MapPart(world_, static_cast<std::uint32_t>(random_.below(kTorusParts))).insert(entity, origin, Angle());
    } catch (const std::invalid_argument&) {  // not free there, or there already
    }
  }
  void interfere(int tick) {
    Entity entity(world_, static_cast<std::uint32_t>(random_.below(world_.entities().size())));
    if (oneIn(8)) entity.setVelocity(random_.vector(oneIn(2) ? 60 : 900));
    if (oneIn(4)) entity.rotate(static_cast<std::int32_t>(random_.below(4000)) - 2000);
    if (oneIn(40)) MapPart(world_, static_cast<std::uint32_t>(random_.below(kTorusParts))).erase(entity);
    if (oneIn(60)) world_.erase(entity.index());
    if (oneIn(10)) put(entity);
    if (oneIn(5)) rules_.isOpen[random_.below(4)] ^= true;
    if (tick == 100) addTorusPart(world_, kTorusParts - 1, random_);
    if (oneIn(60)) saved_ = world_.save();
    if (oneIn(60) && saved_.entities.size() == world_.entities().size()) {
      world_.restore(saved_);
      rules_.open = overlapsOf(world_);
    }
  }

  sim::SeededRandom random_;
  AllKinds rules_;
  World world_;
  WorldState saved_;
};

TEST_P(ContactPairsTest, ContactsBeginAndEndAlternately) {
  std::size_t contacts = 0;
  for (int tick = 0; tick < 600; ++tick) {
    interfere(tick);
    ASSERT_EQ(rules_.takeFault(), "") << "seed " << GetParam() << ", before tick " << tick;
    ASSERT_EQ(rules_.open, overlapsOf(world_)) << "seed " << GetParam() << ", before tick " << tick;
    rules_.over.clear();
    world_.solve();
    ASSERT_EQ(rules_.takeFault(), "") << "seed " << GetParam() << ", tick " << tick;
    ASSERT_EQ(rules_.open, overlapsOf(world_)) << "seed " << GetParam() << ", tick " << tick;
    ASSERT_EQ(world_.fault(world_.save()), std::nullopt) << "seed " << GetParam() << ", tick " << tick;
    contacts += rules_.over.size();
  }
  EXPECT_GT(contacts, 250u) << "too few contacts, seed " << GetParam();
}

INSTANTIATE_TEST_SUITE_P(Seeds, ContactPairsTest, testing::Range<std::uint64_t>(1, 13));

class StripPairsTest : public testing::Test {
 protected:
  StripPairsTest() : world(twoStrips({}, {{{-950, -5000}, {-950, 5000}}})), entity(world, square(100)) {
    world.setRules(rules);
    MapPart(world, 1).insert(entity, {800, 0}, Angle());
  }
  void step(Point velocity) {
    entity.setVelocity(velocity);
    rules.over.clear();
    world.solve();
  }
  std::size_t open() const { return rules.open.size(); }

  class Piercing : public PairedRules {
   public:
    bool pierce(const Entity&, const SegmentRef&) const override { return true; }
  };
  Piercing rules;
  World world;
  Entity entity;
};

TEST_F(StripPairsTest, ContactsEndWhereTheyAreLeft) {
  step({200, 0});
  ASSERT_EQ(open(), 3u) << "the two warps, and the segment behind the edge";
  step({-1000, 0});
  EXPECT_EQ(world.view(0).size(), 1u);
  EXPECT_EQ(open(), 0u);
  EXPECT_EQ(rules.takeFault(), "");
}

// The further instance still overlaps a segment when it is dropped. That contact did not end.
TEST_F(StripPairsTest, ContactsOfADroppedInstanceEnd) {
  World strips = twoStrips({}, {{{-1400, 0}, {-900, 0}}});
  strips.setRules(rules);
  Entity body(strips, square(100));
  MapPart(strips, 1).insert(body, {1000, 0}, Angle());
  strips.solve();
  ASSERT_EQ(open(), 3u);
  rules.over.clear();
  body.setVelocity({-150, 0});
  strips.solve();
  EXPECT_EQ(strips.view(0).size(), 1u);
  EXPECT_EQ(open(), 0u);
  EXPECT_EQ(rules.takeFault(), "");
}

TEST_F(StripPairsTest, ContactsOutlastARehome) {
  step({200, 0});
  const Contacts before = rules.open;
  step({10, 0});
  ASSERT_EQ(entity.part(), 2u);
  EXPECT_EQ(rules.open, before);
  step({500, 0});
  EXPECT_EQ(open(), 0u);
  EXPECT_EQ(rules.takeFault(), "");
}

TEST_F(StripPairsTest, ContactsOfAnErasedInstanceEnd) {
  step({200, 0});
  MapPart(world, 2).erase(entity);
  EXPECT_EQ(open(), 1u) << "the warp in part 1";
  step({0, 0});
  EXPECT_EQ(open(), 3u) << "the instance is added again";
  MapPart(world, 1).erase(entity);
  EXPECT_FALSE(entity.inserted()) << "the other instance is a child of this one";
  EXPECT_EQ(open(), 0u);
  EXPECT_EQ(rules.takeFault(), "");
}

TEST_F(StripPairsTest, ContactsOfARemovedEntityEndOnceAndBeginAgainElsewhere) {
  step({200, 0});
  world.erase(0);
  EXPECT_EQ(open(), 0u);
  world.erase(0);
  MapPart(world, 2).insert(entity, {-950, 0}, Angle());
  EXPECT_EQ(open(), 0u) << "they begin in the next step";
  step({0, 0});
  EXPECT_EQ(open(), 3u);
  EXPECT_EQ(rules.takeFault(), "");
}

// A portion is at most 5°: nothing in it has an earlier time, so the order is fixed, whatever the indices are.
TEST(StepContactsTest, OfAPortionOfARotationEndsAreReportedBeforeBegins) {
  const Segment onlyBefore{{960, 850}, {960, 900}};  // inside of the square before the rotation by 5°
  const Segment onlyAfter{{1040, -900}, {1040, -850}};
  for (const std::uint32_t left : {0u, 1u}) {
    World world;
    addPart(world, 0, left == 0 ? std::vector{onlyBefore, onlyAfter} : std::vector{onlyAfter, onlyBefore});
    RecordedRules rules;
    rules.pierceable = {{0, 0}, {0, 1}};
    world.setRules(rules);
    Entity entity(world, square(1000));
    MapPart(world, 0).insert(entity, {0, 0}, Angle());
    world.solve();
    const std::string ended = "0:" + std::to_string(left);
    const std::string begun = "0:" + std::to_string(1 - left);
    EXPECT_EQ(rules.take(), (std::vector{"begin " + ended, "over " + ended}));
    entity.rotate(500);
    world.solve();
    EXPECT_EQ(rules.take(), (std::vector{"end " + ended, "begin " + begun, "over " + begun}));
  }
}

TEST_F(StripPairsTest, AFreshInstanceThatIsRemovedHasNoContacts) {
  MapPart(world, 2).insert(entity, {-950, 0}, Angle());
  MapPart(world, 2).erase(entity);
  EXPECT_EQ(rules.takeFault(), "");
  step({0, 0});
  EXPECT_EQ(open(), 0u);
}

}  // namespace
}  // namespace platon::step_contacts_test
