// Derived state must not influence results: a long-lived world steps exactly like a fresh copy of it.
#include <gtest/gtest.h>

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>

#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "platon/physics/world.h"
#include "tests/shared/physics/maps.h"
#include "tests/shared/physics/recorded_rules.h"
#include "tests/shared/physics/shapes.h"
#include "tests/shared/physics/torus.h"
#include "tests/sim/seeded_random.h"
#include "tests/support/run/repetitions.h"

namespace platon::derived_state_test {
namespace {

const int kTicks = repetitions(1500);

Angle anyAngle(sim::SeededRandom& random) { return Angle(static_cast<std::int32_t>(random.below(Angle::kTurn))); }

std::int32_t anyTurn(sim::SeededRandom& random, std::int32_t limit) {
  return static_cast<std::int32_t>(random.below(2 * static_cast<std::uint64_t>(limit) + 1)) - limit;
}

// Gives any entity another velocity or rotation when an entity is stopped; the same on every call for the same seed.
class InterferingRules : public RecordedRules {
 public:
  InterferingRules(Scope scope, std::uint64_t seed) : scope_(scope), knowsSolid_(seed % 2 == 0), random_(seed) {
    if (scope == Scope::kContacts) return;
    walls = {{1, 13}, {2, 12}};
    pierceable = {{0, 1}, {1, 1}, {2, 1}};
  }

  Scope scope() const override { return scope_; }
  bool mayPierce(std::uint32_t part, std::uint32_t index) const override {
    return !knowsSolid_ || pierceable.contains({part, index});
  }
  void contact(Entity& entity, const Contact& contact) override {
    RecordedRules::contact(entity, contact);
    const std::uint64_t what = random_.below(20);
    Entity any(entity.world(), static_cast<std::uint32_t>(random_.below(entity.world().entities().size())));
    if (what == 0) any.setVelocity(random_.vector(100), anyAngle(random_));
    if (what == 1) any.rotate(anyTurn(random_, 700));
    if (what == 2) entity.rotate(500);
  }
  void touchContact(Entity& entity, const SegmentRef& segment) override {
    RecordedRules::touchContact(entity, segment);
    if (random_.below(8) != 0) entity.rotate(500);
  }

 private:
  Scope scope_;
  bool knowsSolid_;
  sim::SeededRandom random_;
};

class Watcher : public StepObserver {
 public:
  void leg(std::uint32_t, std::span<const InstanceView>) override {}
};

class DerivedStateTest : public testing::TestWithParam<std::uint64_t> {
 protected:
  DerivedStateTest() : random_(GetParam()) {
    for (std::uint32_t part = 0; part + 1 < kTorusParts; ++part) addTorusPart(world_, part, random_);
    for (int i = 0; i < 6; ++i) put(Entity(world_, i % 2 == 0 ? square(60) : randomConvex(random_, 150)));
    saved_ = world_.save();
  }

  void put(Entity entity) {
    const auto part = static_cast<std::uint32_t>(random_.below(kTorusParts));
    const Point origin = random_.vector(kTorusReach);
    try {
      MapPart(world_, part).insert(entity, origin, oneIn(2) ? Angle() : anyAngle(random_));
    } catch (const std::invalid_argument&) {  // not free there, or there already
    }
  }
  bool oneIn(std::uint64_t times) { return random_.below(times) == 0; }
  // Random changes between two ticks.
  void interfere(int tick) {
    const auto index = static_cast<std::uint32_t>(random_.below(world_.entities().size()));
    Entity entity(world_, index);
    if (oneIn(15)) entity.setVelocity(random_.vector(oneIn(2) ? 60 : 700));
    if (tick % 200 < 100) entity.rotate(anyTurn(random_, oneIn(40) ? 3000 : 100));
    if (oneIn(80)) MapPart(world_, entity.part()).erase(entity);
    if (oneIn(200)) world_.erase(index);
    if (oneIn(30)) put(entity);
    if (tick == 100) addTorusPart(world_, kTorusParts - 1, random_);
    if (oneIn(60)) saved_ = world_.save();
    if (oneIn(60)) world_.restore(saved_);
  }

  sim::SeededRandom random_;
  World world_;
  WorldState saved_;
};

TEST_P(DerivedStateTest, LongLivedWorldsStepLikeFreshCopies) {
  World assigned;  // which keeps its derived state, too
  Watcher watcher;
  for (int tick = 0; tick < kTicks; ++tick) {
    interfere(tick);
    const auto scope = oneIn(8)   ? Rules::Scope::kEverything
                       : oneIn(4) ? Rules::Scope::kSegments
                                  : Rules::Scope::kContacts;
    InterferingRules known(scope, random_.next());
    InterferingRules found = known;
    InterferingRules watched = known;
    World fresh = world_;
    assigned = world_;
    world_.setRules(known);
    world_.solve(oneIn(10) ? &watcher : nullptr);
    fresh.setRules(found);
    fresh.solve();
    assigned.setRules(watched);
    assigned.solve(&watcher);
    world_.resetRules();
    ASSERT_EQ(world_.hash(), fresh.hash()) << "seed " << GetParam() << ", tick " << tick;
    ASSERT_EQ(world_.hash(), assigned.hash()) << "seed " << GetParam() << ", tick " << tick;
    ASSERT_EQ(known.take(), found.calls) << "seed " << GetParam() << ", tick " << tick;
    ASSERT_EQ(found.calls, watched.calls) << "seed " << GetParam() << ", tick " << tick;
    for (const std::string& call : found.calls) {
      ASSERT_TRUE(scope != Rules::Scope::kContacts || call.starts_with("contact") || call.starts_with("touch"))
          << call << ", tick " << tick;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, DerivedStateTest, testing::Range<std::uint64_t>(1, 7));

// A floor of segments whose ends miss each other, with bodies that are pushed over it. The step of a body that slid in
// the last one begins with the segment that stopped it; a copy does not know it.
TEST(SlidingBodyTest, StepsOverLooseFloorsLikeOneThatComesFromElsewhere) {
  sim::SeededRandom random(20261129);
  for (int number = 0; number < repetitions(60); ++number) {
    World world;
    MapPart part(world, 0);
    const std::int32_t slope = static_cast<std::int32_t>(random.below(1001)) - 500;
    const auto floorAt = [&](std::int32_t x) { return Point(x, x * slope / 1000) + random.vector(2); };
    for (std::int32_t x = -3000; x < 3000; x += 50) part.line(floorAt(x), floorAt(x + 50));
    part.initialize();
    std::vector<Entity> bodies;
    for (std::int32_t i = 0; i < 4; ++i) {
      bodies.emplace_back(world, i % 2 == 0 ? square(30) : randomConvex(random, 60));
      part.insert(bodies.back(), floorAt(600 * i - 900) + Point(0, 100), Angle());
    }
    for (int tick = 0; tick < 300; ++tick) {
      // Along the floor, or almost straight into it, so that an end may stop the body.
      Entity& body = bodies[random.below(bodies.size())];
      const auto strength = static_cast<std::int32_t>(100 + random.below(200));
      if (random.below(4) == 0)
        body.setVelocity(Point(strength * slope / 1000, -strength) + random.vector(tick % 2 == 0 ? 8 : 60));
      World copy = world;
      world.solve();
      copy.solve();
      ASSERT_EQ(world.hash(), copy.hash()) << "world " << number << ", tick " << tick;
    }
  }
}

// The 1025th angle is one too many for the cache of shapes. The next one takes the memory of the last one.
TEST(ShapeMemoryTest, AShapeInTheMemoryOfAClearedOneIsNotThatOne) {
  World world;
  addPart(world, 0, {{{-50000, 0}, {50000, 0}}});
  Entity entity(world, square(12000));
  MapPart(world, 0).insert(entity, {0, 20000}, Angle());
  entity.setVelocity({0, -30000});
  WorldState state = world.save();
  for (std::int32_t angle = 30; angle < 33000; angle += 30) {
    state.entities[0].angle = Angle(angle);
    world.restore(state);
    World fresh = world;
    world.solve();
    fresh.solve();
    ASSERT_EQ(world.hash(), fresh.hash()) << "angle " << angle;
  }
}

}  // namespace
}  // namespace platon::derived_state_test
