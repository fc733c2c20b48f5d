#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "platon/exact/integer.h"
#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "platon/physics/world.h"
#include "shared/physics/instances.h"
#include "tests/shared/physics/maps.h"
#include "tests/shared/physics/shapes.h"

namespace platon::world_accepts_test {
namespace {

// One entity across the edge between the strips, and one inserted into both.
class WorldAcceptsTest : public testing::Test {
 protected:
  WorldAcceptsTest() : world(twoStrips()) {
    Entity over(world, square(100));
    MapPart(world, 1).insert(over, {950, 0}, Angle());
    Entity both(world, square(10));
    MapPart(world, 1).insert(both, {0, 0}, Angle());
    MapPart(world, 2).insert(both, {0, 0}, Angle::degrees(90));
    Entity sliver(world, Convex(std::vector<Point>{{0, 0}, {3, 1}, {2, 1}}));
    MapPart(world, 2).insert(sliver, {0, 0}, Angle());
    good = world.save();
  }

  bool acceptsWith(const std::function<void(WorldState&)>& change) const {
    WorldState state = good;
    change(state);
    return world.accepts(state);
  }

  World world;
  WorldState good;
};

constexpr std::int32_t kMax = kCoordinateLimit - 1;

TEST_F(WorldAcceptsTest, AcceptsSavedStates) {
  ASSERT_EQ(good.instances.size(), 2u);
  EXPECT_TRUE(world.accepts(good));
  EXPECT_TRUE(world.accepts(WorldState()));
  EXPECT_TRUE(twoStrips().accepts(WorldState()));
}

TEST_F(WorldAcceptsTest, AcceptsOtherValidValues) {
  EXPECT_TRUE(acceptsWith([](WorldState& s) { s.entities[0].velocity = {kVelocityLimit - 1, 1 - kVelocityLimit}; }));
  EXPECT_TRUE(acceptsWith([](WorldState& s) { s.entities[0].heading = Angle(12345); }));
  EXPECT_TRUE(acceptsWith([](WorldState& s) { s.entities[0].turn = -35999; }));
  EXPECT_TRUE(acceptsWith([](WorldState& s) { s.entities[2].position = {kMax, -kMax}; }));
  EXPECT_TRUE(acceptsWith([](WorldState& s) { s.entities[0].crossings = 4000000000u; }));
}

TEST_F(WorldAcceptsTest, RejectsStatesOfAnotherWorld) {
  EXPECT_FALSE(World().accepts(good)) << "it knows no such shape or part";
  EXPECT_FALSE(twoStrips().accepts(good));
}

TEST_F(WorldAcceptsTest, RejectsInvalidIndices) {
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.entities[0].shape = 3; }));
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.entities[0].shape = 0xffffffff; }));
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.entities[2].part = 3; }));
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.instances[1].part = 3; }));
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.instances[0].warp = 1; }));
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.instances[0].warp = 0xffff; }));
}

TEST_F(WorldAcceptsTest, RejectsWrongInstanceCounts) {
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.entities[0].instances = 0; }));
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.entities[0].instances = 2; }));
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.entities[1].instances = 0xffff; }));
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.instances.pop_back(); }));
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.instances.push_back(s.instances.back()); }));
  EXPECT_FALSE(acceptsWith([](WorldState& s) {
    const InstanceState one = s.instances[1];
    for (std::uint16_t id = 10; s.entities[1].instances < Instances::kMax; ++id) {
      s.instances.push_back(one);
      s.instances.back().id = id;
      ++s.entities[1].instances;
    }
    s.entities.pop_back();
  })) << "more instances than there may be";
}

TEST_F(WorldAcceptsTest, RejectsValuesOutOfRange) {
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.entities[0].position.x = kMax + 1; }));
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.entities[0].position.y = INT32_MIN; }));
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.entities[0].velocity.x = kVelocityLimit; }));
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.entities[0].velocity.y = -kVelocityLimit; }));
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.entities[0].remainder.x = kRemainderLimit + 1; }));
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.entities[0].remainder.y = INT32_MIN; }));
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.entities[0].turn = 36000; }));
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.entities[0].turn = INT32_MIN; }));
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.instances[0].anchor.y = -kMax - 1; }));
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.instances[0].homeAnchor.x = kMax + 1; }));
}

TEST_F(WorldAcceptsTest, RejectsInstancesOutOfRange) {
  EXPECT_FALSE(acceptsWith([](WorldState& s) {
    s.instances[0].anchor.x = kMax - 100;
    s.instances[0].homeAnchor.x = -kMax;
  }));
}

TEST_F(WorldAcceptsTest, RejectsInvalidFlags) {
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.entities[0].inserted = 2; }));
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.entities[0].fresh = 2; }));
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.instances[0].fresh = 0xffff; }));
}

TEST_F(WorldAcceptsTest, RejectsInstancesOfEntitiesInNoPart) {
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.entities[0].inserted = 0; }));
  EXPECT_TRUE(acceptsWith([](WorldState& s) { s.entities[2].inserted = 0; }));
}

TEST_F(WorldAcceptsTest, RejectsUnconnectedInstances) {
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.instances[0].parent = 7; }));
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.instances[0].parent = s.instances[0].id; })) << "on itself";
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.instances[0].part = 1; })) << "its warp leads elsewhere";
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.instances[0].angle = Angle(1); })) << "its warp has a different angle";
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.entities[0].angle = Angle(1); }));
  EXPECT_FALSE(acceptsWith([](WorldState& s) {
    InstanceState second = s.instances[0];
    second.id = 9;
    second.parent = 8;
    second.part = 1;
    s.instances[0].id = 8;
    s.instances[0].parent = 9;
    s.instances.insert(s.instances.begin() + 1, second);
    ++s.entities[0].instances;
  })) << "a cycle";
}

TEST_F(WorldAcceptsTest, AcceptsInstancesInAnyOrder) {
  const auto chained = [](WorldState& s, bool swapped) {
    InstanceState second = s.instances[0];
    second.id = 9;
    second.parent = s.instances[0].id;
    second.part = 1;
    s.instances.insert(s.instances.begin() + (swapped ? 0 : 1), second);
    ++s.entities[0].instances;
  };
  EXPECT_TRUE(acceptsWith([&](WorldState& s) { chained(s, false); }));
  EXPECT_TRUE(acceptsWith([&](WorldState& s) { chained(s, true); }));
}

TEST_F(WorldAcceptsTest, RejectsDuplicateAndReservedIds) {
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.instances[1].id = s.entities[1].id; }));
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.entities[2].id = InstanceState::kNoParent; }));
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.instances[1].id = InstanceState::kNoParent; }));
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.entities[0].nextId = InstanceState::kNoParent; }));
}

TEST_F(WorldAcceptsTest, RejectsAnglesAtWhichTheShapeIsDegenerate) {
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.entities[2].angle = Angle::degrees(20); }));
  EXPECT_TRUE(acceptsWith([](WorldState& s) { s.entities[2].angle = Angle::degrees(90); }));
}

TEST_F(WorldAcceptsTest, AcceptsDestroyedEntitiesWithoutAState) {
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.generations = {0, 0, 1}; })) << "it has a state";
  EXPECT_FALSE(acceptsWith([](WorldState& s) {
    s.entities[2] = EntityState();
    s.entities[2].nextId = 1;
    s.generations = {0, 0, 1};
  }));
  EXPECT_TRUE(acceptsWith([](WorldState& s) {
    s.entities[2] = EntityState();
    s.generations = {0, 0, 1};
  }));
  EXPECT_TRUE(acceptsWith([](WorldState& s) { s.generations = {4, 0, 0xfffffffe}; }));
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.generations = {2, 0}; })) << "two states of one world";
  EXPECT_FALSE(acceptsWith([](WorldState& s) { s.generations = {0, 0, 0, 2}; })) << "of which entity?";
}

TEST_F(WorldAcceptsTest, NamesTheFault) {
  const auto fault = [this](const std::function<void(WorldState&)>& change) {
    WorldState state = good;
    change(state);
    return world.fault(state).value_or("none");
  };
  EXPECT_EQ(fault([](WorldState&) {}), "none");
  EXPECT_EQ(fault([](WorldState& s) { s.entities[0].instances = 9; }),
            "entity 0: the state has fewer instances than it names");
  EXPECT_EQ(fault([](WorldState& s) { s.entities[0].inserted = 0; }),
            "entity 0: it is in no map part but has further instances");
  EXPECT_EQ(fault([](WorldState& s) { s.entities[1].id = s.instances[1].id; }),
            "entity 1: two of its instances have the same id, or one has the id 65535");
  EXPECT_EQ(fault([](WorldState& s) { s.entities[2].angle = Angle::degrees(20); }),
            "entity 2: its shape is degenerate at the rotation of an instance");
  EXPECT_EQ(fault([](WorldState& s) { s.generations = {1}; }), "entity 0: it is destroyed, but a value of it is not 0");
  EXPECT_EQ(fault([](WorldState& s) { s.generations = {0, 0, 0, 2}; }), "the state has more generations than entities");
  EXPECT_EQ(fault([](WorldState& s) { s.generations = {0}; }), "the last generation of the state is 0: leave it out");
  EXPECT_EQ(fault([](WorldState& s) { s.instances[0].parent = 7; }),
            "entity 0: no warp leads to a further instance from its parent");
}

// Only "a value is out of range" was said.
TEST_F(WorldAcceptsTest, NamesTheFieldThatIsOutOfRange) {
  const auto field = [this](const std::function<void(EntityState&, InstanceState&)>& change) {
    WorldState state = good;
    change(state.entities[1], state.instances[1]);
    const std::string text = world.fault(state).value_or("none");
    return text.substr(0, text.find(" is"));
  };
  const std::string second = "entity 1: ";
  EXPECT_EQ(field([](EntityState& e, InstanceState&) { e.position.y = kMax + 1; }), second + "position");
  EXPECT_EQ(field([](EntityState& e, InstanceState&) { e.velocity.x = -kVelocityLimit; }), second + "velocity");
  EXPECT_EQ(field([](EntityState& e, InstanceState&) { e.remainder.x = kRemainderLimit + 1; }), second + "remainder");
  EXPECT_EQ(field([](EntityState& e, InstanceState&) { e.turn = Angle::kTurn; }), second + "turn");
  EXPECT_EQ(field([](EntityState& e, InstanceState&) { e.nextId = InstanceState::kNoParent; }), second + "nextId");
  EXPECT_EQ(field([](EntityState& e, InstanceState&) { e.inserted = 2; }), second + "inserted");
  EXPECT_EQ(field([](EntityState& e, InstanceState&) { e.fresh = 2; }), second + "fresh");
  const std::string further = second + "further instance 0: ";
  EXPECT_EQ(field([](EntityState&, InstanceState& i) { i.part = 3; }), further + "part");
  EXPECT_EQ(field([](EntityState&, InstanceState& i) { i.homeAnchor.x = kMax + 1; }), further + "homeAnchor");
  EXPECT_EQ(field([](EntityState&, InstanceState& i) { i.anchor.x = kMax + 1; }), further + "anchor");
  EXPECT_EQ(field([](EntityState& e, InstanceState&) { e.position.x = kMax; }), "none");
  EXPECT_EQ(field([](EntityState& e, InstanceState& i) {
              e.position.x = kMax;
              i.anchor.y = kMax;
            }),
            further + "homeAnchor and anchor lead to a position that");
  EXPECT_EQ(field([](EntityState&, InstanceState& i) { i.fresh = 2; }), further + "fresh");
}

TEST_F(WorldAcceptsTest, AcceptedStatesCanBeStepped) {
  constexpr std::uint64_t seed = 2024;
  sim::SeededRandom random(seed);
  int accepted = 0;
  for (int round = 0; round < 20000; ++round) {
    WorldState state = good;
    const auto mutate = [&](const char*, auto& field) {
      if (random.below(25) != 0) return;
      using Field = std::decay_t<decltype(field)>;
      const std::uint64_t bits = random.next() >> random.below(64);
      if constexpr (std::is_same_v<Field, Point>) {
        field += Point(static_cast<std::int16_t>(bits), static_cast<std::int16_t>(bits >> 16));
        if (random.below(3) == 0) field = Point(static_cast<std::int32_t>(bits), static_cast<std::int32_t>(bits >> 32));
      } else if constexpr (std::is_same_v<Field, Angle>) {
        field = Angle(static_cast<std::int32_t>(bits));
      } else {
        field = static_cast<Field>(static_cast<std::uint64_t>(field) ^ (bits & (bits >> 8)));
      }
    };
    for (EntityState& entity : state.entities) EntityState::visit(entity, mutate);
    for (InstanceState& instance : state.instances) InstanceState::visit(instance, mutate);
    if (!world.accepts(state)) continue;
    ++accepted;
    World copy = world;
    copy.restore(state);
    copy.solve();
    copy.solve();
    ASSERT_TRUE(copy.accepts(copy.save())) << "seed " << seed << ", round " << round;
  }
  EXPECT_GT(accepted, 1000);
  EXPECT_LT(accepted, 19000);
}

}  // namespace
}  // namespace platon::world_accepts_test
