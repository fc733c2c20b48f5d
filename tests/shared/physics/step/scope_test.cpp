// The fast paths for rules that ask for less, and repeated steps at rest, must not change any result.
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "platon/physics/world.h"
#include "tests/shared/physics/maps.h"
#include "tests/shared/physics/recorded_rules.h"
#include "tests/shared/physics/shapes.h"
#include "tests/sim/seeded_random.h"

namespace platon::scope_test {
namespace {

constexpr std::uint64_t kSeed = 31;
constexpr int kTicks = 600;

class ContactRules : public RecordedRules {
 public:
  Scope scope() const override { return Scope::kContacts; }
};

auto asTuple(const Contact& contact) {
  return std::tuple(contact.segment.part, contact.segment.index, contact.segment.instance, contact.point.x,
                    contact.point.y, contact.normal.x, contact.normal.y, contact.segment.toHome.centidegrees(),
                    contact.time.numerator, contact.time.denominator);
}

void expectSameContacts(const RecordedRules& one, const RecordedRules& other) {
  ASSERT_EQ(one.contacts.size(), other.contacts.size());
  for (std::size_t i = 0; i < one.contacts.size(); ++i) {
    EXPECT_EQ(asTuple(one.contacts[i]), asTuple(other.contacts[i]));
  }
}

// A closed room of two strips with random segments. Velocities change once per second, so that many entities come to
// rest.
class ScopeTest : public testing::Test {
 protected:
  ScopeTest() : world_(strips()) {
    for (int i = 0; i < 60 && world_.entities().size() < 4; ++i) {
      Entity entity(world_, square(40));
      try {
        MapPart(world_, i % 2 == 0 ? 1u : 2u).insert(entity, random_.vector(900), Angle());
      } catch (const std::invalid_argument&) {
      }
    }
  }

  World strips() {
    std::vector<Segment> lines[2] = {
        {{{-950, -950}, {-950, 950}}, {{-950, 950}, {1000, 950}}, {{-950, -950}, {1000, -950}}},
        {{{950, -950}, {950, 950}}, {{-1000, 950}, {950, 950}}, {{-1000, -950}, {950, -950}}}};
    for (int i = 0; i < 20; ++i) {
      const Point a = random_.vector(900);
      lines[i % 2].push_back({a, a + random_.vector(200)});
    }
    return twoStrips(lines[0], lines[1]);
  }
  void changeVelocities(World& other) {
    for (std::uint32_t i = 0; i < world_.entities().size(); ++i) {
      const Point velocity = random_.vector(150);
      Entity(world_, i).setVelocity(velocity);
      Entity(other, i).setVelocity(velocity);
    }
  }

  sim::SeededRandom random_{kSeed};
  World world_;
};

TEST_F(ScopeTest, HasTheSameResultsAndContacts) {
  World other = world_;
  for (int tick = 0; tick < kTicks; ++tick) {
    if (tick % 60 == 0) changeVelocities(other);
    ContactRules ignoring;
    RecordedRules recording;
    world_.setRules(ignoring);
    world_.solve();
    other.setRules(recording);
    other.solve();
    ASSERT_EQ(world_, other) << "seed " << kSeed << ", tick " << tick;
    expectSameContacts(ignoring, recording);
  }
}

// Records what it hears of segments that are no warps.
class WallRules : public RecordedRules {
 public:
  explicit WallRules(Scope scope) : scope_(scope) {
    for (std::uint32_t segment = 3; segment < 13; ++segment) pierceable.insert({1 + segment % 2, segment});
  }
  Scope scope() const override { return scope_; }
  bool pierce(const Entity& entity, const SegmentRef& segment) const override {
    EXPECT_FALSE(segment.warp && scope_ == Scope::kSegments) << "asked of a warp";
    return RecordedRules::pierce(entity, segment);
  }
  void beginContact(Entity& entity, const SegmentRef& segment) override {
    if (!segment.warp) RecordedRules::beginContact(entity, segment);
  }
  void overContact(Entity& entity, const SegmentRef& segment) override {
    if (!segment.warp) RecordedRules::overContact(entity, segment);
  }
  void endContact(Entity& entity, const SegmentRef& segment) override {
    if (!segment.warp) RecordedRules::endContact(entity, segment);
  }

 private:
  Scope scope_;
};

TEST_F(ScopeTest, SegmentsAreReportedAsByRulesThatAskForEverything) {
  World other = world_;
  std::size_t reported = 0;
  for (int tick = 0; tick < kTicks; ++tick) {
    if (tick % 60 == 0) changeVelocities(other);
    WallRules segments(Rules::Scope::kSegments);
    WallRules everything(Rules::Scope::kEverything);
    world_.setRules(segments);
    world_.solve();
    other.setRules(everything);
    other.solve();
    ASSERT_EQ(world_, other) << "seed " << kSeed << ", tick " << tick;
    ASSERT_EQ(segments.calls, everything.calls) << "seed " << kSeed << ", tick " << tick;
    reported += segments.calls.size() - segments.contacts.size();
  }
  EXPECT_GT(reported, 40u);
}

// As WallRules with Scope::kSegments, which also say what cannot be pierced.
class SolidRules : public WallRules {
 public:
  SolidRules() : WallRules(Scope::kSegments) {}
  bool mayPierce(std::uint32_t part, std::uint32_t index) const override { return pierceable.contains({part, index}); }
  bool pierce(const Entity& entity, const SegmentRef& segment) const override {
    EXPECT_TRUE(mayPierce(segment.part, segment.index)) << "asked of a solid segment";
    return WallRules::pierce(entity, segment);
  }
};

// `world_` repeats steps of entities at rest, `fresh` has no recorded rest.
TEST_F(ScopeTest, WhatCannotBePiercedIsNotAskedFor) {
  World other = world_;
  int resting = 0;
  for (int tick = 0; tick < kTicks; ++tick) {
    if (tick % 60 == 0) changeVelocities(other);
    World fresh = world_;
    const WorldState before = world_.save();
    SolidRules repeated;
    SolidRules computed;
    WallRules asked(Rules::Scope::kSegments);
    world_.setRules(repeated);
    world_.solve();
    fresh.setRules(computed);
    fresh.solve();
    other.setRules(asked);
    other.solve();
    ASSERT_EQ(world_, other) << "seed " << kSeed << ", tick " << tick;
    ASSERT_EQ(world_, fresh) << "seed " << kSeed << ", tick " << tick;
    ASSERT_EQ(repeated.calls, asked.calls) << "seed " << kSeed << ", tick " << tick;
    ASSERT_EQ(computed.calls, asked.calls) << "seed " << kSeed << ", tick " << tick;
    for (std::size_t i = 0; i < before.entities.size(); ++i)
      resting += before.entities[i] == world_.entities()[i] ? 1 : 0;
  }
  EXPECT_GT(resting, kTicks / 4) << "too few entities have come to rest";
}

// Rules for a floor, the segment 0 of part 0.
class FloorRules : public Rules {
 public:
  FloorRules(Scope scope, bool solid, bool open) : scope_(scope), solid_(solid), open_(open) {}
  Scope scope() const override { return scope_; }
  bool mayPierce(std::uint32_t, std::uint32_t) const override { return !solid_; }
  bool pierce(const Entity&, const SegmentRef&) const override {
    ++asked;
    return open_;
  }

  mutable int asked = 0;

 private:
  Scope scope_;
  bool solid_;
  bool open_;
};

TEST(ScopeWorldTest, AFloorThatOpensWakesWhoRestsOnIt) {
  using enum Rules::Scope;
  for (const auto& [scope, solid] : {std::pair(kContacts, true), std::pair(kSegments, true),
                                     std::pair(kSegments, false), std::pair(kEverything, false)}) {
    World world;
    addPart(world, 0, {{{-500, -100}, {500, -100}}});
    Entity entity(world, square(100));
    MapPart(world, 0).insert(entity, {0, 0}, Angle());
    entity.setVelocity({0, -10});
    FloorRules closed(scope, solid, false);
    world.setRules(closed);
    for (int tick = 0; tick < 5; ++tick) world.solve();
    ASSERT_EQ(entity.position(), Point(0, 0));
    EXPECT_EQ(closed.asked > 0, !solid);
    FloorRules open(kSegments, false, true);
    world.setRules(open);
    world.solve();
    EXPECT_EQ(entity.position(), Point(0, -10));
  }
}

TEST(ScopeWorldTest, WhoOverlapsAFloorThatClosesCanLeaveIt) {
  for (const bool solid : {true, false}) {
    World world;
    addPart(world, 0, {{{-500, -100}, {500, -100}}});
    Entity entity(world, square(100));
    MapPart(world, 0).insert(entity, {0, 0}, Angle());
    const auto move = [&](std::int32_t y, bool open) {
      FloorRules rules(Rules::Scope::kSegments, solid && !open, open);
      world.setRules(rules);
      entity.setVelocity({0, y});
      world.solve();
      world.resetRules();
      return entity.position().y;
    };
    EXPECT_EQ(move(-10, true), -10);
    EXPECT_EQ(move(-10, false), -20);
    EXPECT_EQ(move(50, false), 30);
    EXPECT_EQ(move(-50, false), 0) << "it has left the floor";
  }
}

TEST_F(ScopeTest, RepeatedStepsEqualComputedSteps) {
  World other = world_;
  int resting = 0;
  for (int tick = 0; tick < kTicks; ++tick) {
    if (tick % 60 == 0) changeVelocities(other);
    const WorldState before = world_.save();
    World moved = world_;  // has no recorded rest
    ContactRules repeated;
    ContactRules found;
    world_.setRules(repeated);
    world_.solve();
    moved.setRules(found);
    moved.solve();
    ASSERT_EQ(world_, moved) << "seed " << kSeed << ", tick " << tick;
    expectSameContacts(repeated, found);
    EXPECT_EQ(repeated.calls, found.calls);
    for (std::size_t i = 0; i < before.entities.size(); ++i) {
      resting += before.entities[i] == world_.entities()[i] ? 1 : 0;
    }
  }
  EXPECT_GT(resting, kTicks / 4) << "too few entities have come to rest";
}

TEST(ScopeWorldTest, AddingAPartWakesRestingEntities) {
  World world;
  addLeftStrip(world);
  Entity entity(world, square(100));
  MapPart(world, 1).insert(entity, {0, 0}, Angle());
  entity.setVelocity({300, 0});
  for (int tick = 0; tick < 10; ++tick) world.solve();
  ASSERT_EQ(entity.part(), 1u);
  addRightStrip(world);
  for (int tick = 0; tick < 10; ++tick) world.solve();
  EXPECT_EQ(entity.part(), 2u);
}

// The floor is hit immediately and has a lower index than the pierceable segment.
TEST(ScopeWorldTest, OtherRulesStillReceiveOverContact) {
  World world = twoStrips({{{-500, -100}, {500, -100}}, {{0, -90}, {0, 500}}});
  Entity entity(world, square(100));
  RecordedRules rules;
  rules.pierceable = {{1, 1}};
  world.setRules(rules);
  MapPart(world, 1).insert(entity, {0, 0}, Angle());
  world.solve();
  rules.take();
  entity.setVelocity({0, -10});
  world.solve();
  EXPECT_EQ(rules.take(), (std::vector<std::string>{"contact 1:0", "over 1:1"}));
}

}  // namespace
}  // namespace platon::scope_test
