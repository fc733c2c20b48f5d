#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "platon/physics/world.h"
#include "tests/shared/physics/maps.h"
#include "tests/shared/physics/recorded_rules.h"
#include "tests/shared/physics/shapes.h"

namespace platon::callbacks_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// Runs `action` at the first contact.
class ActingRules : public RecordedRules {
 public:
  void contact(Entity& entity, const Contact& contact) override {
    RecordedRules::contact(entity, contact);
    if (action) std::exchange(action, nullptr)(entity);
  }
  std::function<void(Entity&)> action;
};

// Two squares of 20 by 20 that fall onto segment 1. They pass segment 0 on their way.
class CallbackTest : public testing::Test {
 protected:
  CallbackTest() : first(world, square(10)), second(world, square(10)) {
    world.setRules(rules);
    rules.pierceable = {{0, 0}};
    addPart(world, 0, {{{-100, 30}, {100, 30}}, {{-100, 0}, {100, 0}}});
    MapPart(world, 0).insert(first, {-50, 60}, Angle());
    MapPart(world, 0).insert(second, {50, 60}, Angle());
    first.setVelocity({0, -60});
    second.setVelocity({0, -60});
  }
  std::vector<std::string> solve(std::function<void(Entity&)> action) {
    rules.action = std::move(action);
    world.solve();
    return rules.take();
  }
  // The std::logic_error that `action` causes in a callback.
  std::string refusedIn(const std::function<void(Entity&)>& action) {
    std::string text;
    solve([&](Entity& entity) {
      try {
        action(entity);
      } catch (const std::logic_error& reason) {
        text = reason.what();
      }
    });
    return text;
  }

  ActingRules rules;
  World world;
  Entity first;
  Entity second;
};

constexpr const char* kAll[] = {"begin 0:0", "end 0:0", "contact 0:1", "begin 0:0", "end 0:0", "contact 0:1"};

TEST_F(CallbackTest, AreCalledAfterAllEntitiesHaveMoved) {
  Point places[2];
  EXPECT_THAT(solve([&](Entity& entity) {
                EXPECT_EQ(entity.index(), 0u);
                places[0] = first.position();
                places[1] = second.position();
              }),
              testing::ElementsAreArray(kAll));
  EXPECT_EQ(places[0], Point(-50, 10));
  EXPECT_EQ(places[1], Point(50, 10));
}

// The step wrote to freed memory.
TEST_F(CallbackTest, MayAddEntities) {
  EXPECT_THAT(solve([](Entity& entity) {
                for (int i = 0; i < 100; ++i) {
                  Entity added(entity.world(), square(5 + i));
                  if (i < 3) MapPart(entity.world(), 0).insert(added, {0, 1000 + i}, Angle());
                }
              }),
              testing::ElementsAreArray(kAll));
  EXPECT_EQ(world.entities().size(), 102u);
  EXPECT_EQ(first.position(), Point(-50, 10));
  EXPECT_EQ(second.position(), Point(50, 10));
  EXPECT_EQ(world.fault(world.save()), std::nullopt);
}

// The state was one that the world itself refused.
TEST_F(CallbackTest, MayEraseAndRemove) {
  EXPECT_THAT(solve([](Entity& entity) {
                MapPart(entity.world(), 0).erase(entity);
                entity.world().erase(1);
              }),
              testing::ElementsAreArray(kAll))
      << "the events of an entity that was removed are delivered";
  EXPECT_FALSE(first.inserted());
  EXPECT_FALSE(second.inserted());
  EXPECT_EQ(world.fault(world.save()), std::nullopt);
  EXPECT_THAT(solve(nullptr), IsEmpty());
}

// Of the second entity, the contact is dropped, and the begin and the end are delivered with a handle to nothing. The
// new entity, which has its index, gets none of its events.
TEST_F(CallbackTest, MayDestroyEntities) {
  EXPECT_THAT(solve([](Entity& entity) {
                World& mine = entity.world();
                entity.destroy();
                mine.destroy(1);
                const Entity added(mine, square(7));
                EXPECT_EQ(added.index(), 0u);
              }),
              ElementsAre("begin 0:0", "end 0:0", "contact 0:1", "begin 0:0", "end 0:0"));
  EXPECT_FALSE(first.exists());
  EXPECT_FALSE(second.exists());
  EXPECT_EQ(world.fault(world.save()), std::nullopt);
  EXPECT_THAT(solve(nullptr), IsEmpty());
}

// It placed the entity again, whose further instances were then those of the next entity.
TEST_F(CallbackTest, CannotPlaceAnEntityThatIsBeingDestroyed) {
  class Rules : public RecordedRules {
   public:
    void endContact(Entity& entity, const SegmentRef& segment) override {
      RecordedRules::endContact(entity, segment);
      EXPECT_FALSE(entity.exists());
      EXPECT_THROW(MapPart(entity.world(), 0).insert(entity, {0, 1000}, Angle()), std::invalid_argument);
      EXPECT_THROW(entity.destroy(), std::invalid_argument);
    }
  };
  Rules placing;
  placing.pierceable = {{0, 0}};
  first.setVelocity({0, -30});  // stops on the segment that it passes
  solve(nullptr);
  world.setRules(placing);
  first.destroy();
  EXPECT_THAT(placing.take(), ElementsAre("end 0:0"));
  EXPECT_FALSE(world.exists(0u));
  EXPECT_EQ(world.fault(world.save()), std::nullopt);
}

TEST_F(CallbackTest, AThrowingCallbackLeavesAnEntityDestroyed) {
  class Rules : public RecordedRules {
   public:
    void endContact(Entity&, const SegmentRef&) override { throw std::runtime_error("no"); }
  };
  Rules throwing;
  throwing.pierceable = {{0, 0}};
  first.setVelocity({0, -30});
  solve(nullptr);
  world.setRules(throwing);
  EXPECT_THROW(first.destroy(), std::runtime_error);
  EXPECT_FALSE(first.exists());
}

TEST_F(CallbackTest, MayChangeEntitiesAndParts) {
  solve([](Entity& entity) {
    entity.setVelocity({0, 20});
    entity.rotate(300);
    Entity(entity.world(), 1).addVelocity({0, 65});
    addPart(entity.world(), 1, {{{0, 0}, {100, 0}}});
    MapPart(entity.world(), 1).insert(entity, {0, 100}, Angle());
  });
  EXPECT_EQ(world.view(0).size(), 2u);
  solve(nullptr);
  EXPECT_NE(first.rotation(), Angle()) << "as far as the segment below allows";
  EXPECT_EQ(second.position(), Point(50, 15));
  EXPECT_EQ(world.fault(world.save()), std::nullopt);
}

TEST_F(CallbackTest, MoveAnEntityToAnotherPlace) {
  solve([](Entity& entity) {
    entity.world().erase(0);
    MapPart(entity.world(), 0).insert(entity, {0, 35}, Angle());
    entity.setVelocity({});
  });
  EXPECT_EQ(first.position(), Point(0, 35));
  EXPECT_THAT(solve(nullptr), ElementsAre("begin 0:0", "over 0:0", "contact 0:1"));
}

TEST_F(CallbackTest, EventsThatACallbackCausesComeAfterThoseThatWait) {
  first.setVelocity({0, -60});
  second.setVelocity({0, -35});
  EXPECT_THAT(solve([](Entity& entity) { entity.world().erase(1); }),
              ElementsAre("begin 0:0", "end 0:0", "contact 0:1", "begin 0:0", "over 0:0", "end 0:0"));
}

TEST_F(CallbackTest, MaySetOtherRules) {
  RecordedRules others;
  EXPECT_THAT(solve([&](Entity& entity) { entity.world().setRules(others); }),
              ElementsAre("begin 0:0", "end 0:0", "contact 0:1"));
  EXPECT_THAT(others.take(), ElementsAre("begin 0:0", "end 0:0", "contact 0:1"));
  rules.action = nullptr;
  world.setRules(rules);
  EXPECT_THAT(solve([&](Entity& entity) { entity.world().resetRules(); }), ElementsAre("contact 0:1"));
}

TEST_F(CallbackTest, MayNotSolveRestoreOrAssign) {
  const WorldState state = world.save();
  const World before = world;
  World expected = world;
  ActingRules none;
  none.pierceable = rules.pierceable;
  expected.setRules(none);
  expected.solve();
  for (const std::function<void(World&)>& change : {std::function<void(World&)>([](World& w) { w.solve(); }),
                                                    {[&](World& w) { w.restore(state); }},
                                                    {[&](World& w) { w.restoreUnchecked(state); }},
                                                    {[&](World& w) { w = before; }},
                                                    {[&](World& w) { w = World(before); }}}) {
    EXPECT_THAT(refusedIn([&](Entity& entity) { change(entity.world()); }),
                HasSubstr("a callback of Rules cannot solve, restore or assign to its world"));
    EXPECT_EQ(world, expected);
    world.restore(state);
  }
}

TEST_F(CallbackTest, MayCopyTheWorldAndSolveTheCopy) {
  solve([](Entity& entity) {
    World copy = entity.world();
    copy.resetRules();
    copy.solve();
  });
  EXPECT_EQ(first.position(), Point(-50, 10));
}

// A copy that predicts was counted by the rules of the original.
TEST_F(CallbackTest, SolveByOtherRulesLeavesTheRulesOfTheWorld) {
  RecordedRules others;
  World copy = world;
  copy.solve(others);
  EXPECT_THAT(others.take(), ElementsAre("contact 0:0", "contact 0:0")) << "they do not let segment 0 be passed";
  EXPECT_THAT(rules.take(), IsEmpty());
  EXPECT_EQ(copy.entities()[0].position, Point(-50, 40));
  EXPECT_THAT(solve(nullptr),
              ElementsAre("begin 0:0", "end 0:0", "contact 0:1", "begin 0:0", "end 0:0", "contact 0:1"));
  copy.solve();
  EXPECT_THAT(others.take(), IsEmpty());
  EXPECT_THAT(rules.take(), ElementsAre("begin 0:0", "end 0:0", "contact 0:1", "begin 0:0", "end 0:0", "contact 0:1"))
      << "the copy has the rules of the original";
}

TEST_F(CallbackTest, SolveByOtherRulesDeliversAllItsEventsToThem) {
  second.setVelocity({0, -35});
  ActingRules others;
  others.pierceable = rules.pierceable;
  others.action = [&](Entity& entity) {
    entity.world().setRules(rules);
    entity.world().erase(1);
  };
  world.resetRules();
  world.solve(others);
  EXPECT_THAT(others.take(), ElementsAre("begin 0:0", "end 0:0", "contact 0:1", "begin 0:0", "over 0:0", "end 0:0"));
  EXPECT_THAT(rules.take(), IsEmpty());
  world.solve();
  EXPECT_THAT(rules.take(), ElementsAre("contact 0:1")) << "they were set for later calls";
}

TEST_F(CallbackTest, SolveByOtherRulesEndsWithAnException) {
  ActingRules others;
  others.pierceable = rules.pierceable;
  others.action = [](Entity&) { throw std::runtime_error("callback"); };
  EXPECT_THROW(world.solve(others), std::runtime_error);
  EXPECT_THAT(solve(nullptr), ElementsAre("contact 0:1", "contact 0:1"));
  EXPECT_THAT(refusedIn([&](Entity& entity) { entity.world().solve(others); }),
              HasSubstr("a callback of Rules cannot solve, restore or assign to its world"));
  EXPECT_THAT(solve(nullptr), ElementsAre("contact 0:1", "contact 0:1")) << "the refused call has set no rules";
}

TEST_F(CallbackTest, MayAskWhetherABodyFits) {
  bool high = false;
  bool low = true;
  solve([&](Entity& entity) {
    high = MapPart(entity.world(), 0).canPlace(entity, {0, 10}, Angle());
    low = MapPart(entity.world(), 0).canPlace(entity, {0, 9}, Angle());
  });
  EXPECT_TRUE(high);
  EXPECT_FALSE(low);
}

TEST_F(CallbackTest, AThrowingCallbackLeavesTheStepComplete) {
  EXPECT_THROW(solve([](Entity&) { throw std::runtime_error("callback"); }), std::runtime_error);
  EXPECT_THAT(rules.take(), ElementsAre("begin 0:0", "end 0:0", "contact 0:1")) << "the others are dropped";
  EXPECT_EQ(first.position(), Point(-50, 10));
  EXPECT_EQ(second.position(), Point(50, 10));
  EXPECT_EQ(world.fault(world.save()), std::nullopt);
  EXPECT_THAT(solve(nullptr), ElementsAre("contact 0:1", "contact 0:1"));
}

TEST_F(CallbackTest, AWorldThatIsMovedDropsTheEventsThatWait) {
  std::optional<World> elsewhere;
  EXPECT_THAT(solve([&](Entity& entity) { elsewhere.emplace(std::move(entity.world())); }),
              ElementsAre("begin 0:0", "end 0:0", "contact 0:1"));
  elsewhere->solve();
  EXPECT_THAT(rules.take(), ElementsAre("contact 0:1", "contact 0:1"));
}

TEST_F(CallbackTest, AWorldThatIsSwappedDropsTheEventsThatWait) {
  World other = world;
  const World before = world;
  EXPECT_THAT(solve([&](Entity& entity) { std::swap(entity.world(), other); }),
              ElementsAre("begin 0:0", "end 0:0", "contact 0:1"));
  EXPECT_EQ(world, before) << "the other world is here now";
  EXPECT_EQ(&first.world(), &other) << "the handles have followed";
  rules.action = nullptr;
  other.solve();
  EXPECT_THAT(rules.take(), ElementsAre("contact 0:1", "contact 0:1"));
}

TEST(CallbackFrameTest, ToHomeLeadsToTheHomePartAfterTheStep) {
  World world;
  MapPart left(world, 1);
  left.warp({1000, -5000}, {1000, 5000}, 2, {-5000, -1000}, {5000, -1000});
  left.line({900, -600}, {900, 600});
  left.initialize();
  MapPart right(world, 2);
  right.warp({5000, -1000}, {-5000, -1000}, 1, {1000, 5000}, {1000, -5000});
  right.initialize();
  class Frames : public RecordedRules {
   public:
    void endContact(Entity& entity, const SegmentRef& segment) override {
      if (segment.warp) return;
      home = entity.part();
      toHome = segment.toHome;
    }
    std::uint32_t home = 0;
    Angle toHome;
  };
  Frames rules;
  rules.pierceable = {{1, 0}};
  world.setRules(rules);
  Entity entity(world, square(100));
  MapPart(world, 1).insert(entity, {700, 0}, Angle());
  entity.setVelocity({700, 0});
  world.solve();
  EXPECT_EQ(rules.home, 2u);
  EXPECT_EQ(rules.toHome, Angle::degrees(-90)) << "from part 1 to part 2";
}

// Tries to change the world during a step.
class ChangingRules : public RecordedRules {
 public:
  bool pierce(const Entity& entity, const SegmentRef& segment) const override {
    if (change) std::exchange(change, nullptr)(entity.world());
    return RecordedRules::pierce(entity, segment);
  }
  mutable std::function<void(World&)> change;
};

class ChangingObserver : public StepObserver {
 public:
  explicit ChangingObserver(std::function<void()> change) : change_(std::move(change)) {}
  void leg(std::uint32_t, std::span<const InstanceView>) override { change_(); }

 private:
  std::function<void()> change_;
};

TEST(StepTest, NothingChangesAWorldDuringItsStep) {
  World world;
  addPart(world, 0, {{{-100, 0}, {100, 0}}});
  Entity entity(world, square(10));
  MapPart part(world, 0);
  part.insert(entity, {0, 20}, Angle());
  MapPart other(world, 7);
  entity.setVelocity({0, -20});
  const World before = world;
  ChangingRules rules;
  const std::vector<std::function<void(World&)>> changes = {[](World& w) { w.solve(); },
                                                            [&](World& w) { w.restore(before.save()); },
                                                            [&](World& w) { w.restoreUnchecked(before.save()); },
                                                            [&](World& w) { w = before; },
                                                            [&](World& w) { w.setRules(rules); },
                                                            [](World& w) { w.resetRules(); },
                                                            [](World& w) { w.addShape(square(3)); },
                                                            [](World& w) { (void)Entity(w, square(10)); },
                                                            [](World& w) { w.erase(0); },
                                                            [](World& w) { w.destroy(0); },
                                                            [&](World&) { part.erase(entity); },
                                                            [&](World&) {
                                                              part.insert(entity, {50, 50}, Angle());
                                                            },
                                                            [&](World&) { other.initialize(); },
                                                            [&](World&) {
                                                              (void)part.canPlace(entity, {50, 50}, Angle());
                                                            },
                                                            [](World& w) {
                                                              Entity(w, 0).setVelocity({1, 1});
                                                            },
                                                            [](World& w) {
                                                              Entity(w, 0).addVelocity({1, 1});
                                                            },
                                                            [](World& w) { Entity(w, 0).rotate(100); }};
  world.setRules(rules);
  for (std::size_t i = 0; i < changes.size(); ++i) {
    rules.change = changes[i];
    EXPECT_THROW(world.solve(), std::logic_error) << i;
    EXPECT_EQ(world, before) << i;
    ChangingObserver observer([&] { changes[i](world); });
    EXPECT_THROW(world.solve(&observer), std::logic_error) << i;
    EXPECT_EQ(world, before) << i;
  }
  rules.change = [](World& w) { w.erase(0); };
  try {
    world.solve();
    FAIL();
  } catch (const std::logic_error& reason) {
    EXPECT_THAT(reason.what(), HasSubstr("the world cannot be changed during a step"));
  }
  world.solve();
  EXPECT_EQ(entity.position(), Point(0, 10));
}

TEST(StepTest, AWorldThatIsMovedDuringItsStepSaysSo) {
  World world;
  addPart(world, 0, {{{-100, 0}, {100, 0}}});
  Entity entity(world, square(10));
  MapPart(world, 0).insert(entity, {0, 20}, Angle());
  entity.setVelocity({0, -20});
  const World before = world;
  ChangingRules rules;
  world.setRules(rules);
  std::optional<World> elsewhere;
  rules.change = [&](World& w) { elsewhere.emplace(std::move(w)); };
  EXPECT_THROW(world.solve(), std::logic_error);
  EXPECT_EQ(*elsewhere, before);
  elsewhere->solve();
  EXPECT_EQ(elsewhere->entities()[0].position, Point(0, 10));
}

// It went on with the state of a world that was moved from.
TEST(StepTest, AWorldThatAnObserverMovesSaysSo) {
  World world;
  addPart(world, 0, {{{-100, 0}, {100, 0}}});
  for (const std::int32_t x : {-50, 50}) {
    Entity entity(world, square(10));
    MapPart(world, 0).insert(entity, {x, 20}, Angle());
    entity.setVelocity({0, -20});
  }
  std::optional<World> elsewhere;
  ChangingObserver observer([&] {
    if (!elsewhere) elsewhere.emplace(std::move(world));
  });
  EXPECT_THROW(world.solve(&observer), std::logic_error);
  elsewhere->solve();
  EXPECT_EQ(elsewhere->entities()[1].position, Point(50, 10));
}

}  // namespace
}  // namespace platon::callbacks_test
