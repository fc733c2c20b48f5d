#include "platon/physics/reflect.h"

#include <gtest/gtest.h>

#include <string>

#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "platon/physics/segment.h"
#include "platon/physics/world.h"
#include "tests/exactness/oracle/exact_geometry.h"
#include "tests/shared/physics/maps.h"
#include "tests/shared/physics/refusal.h"
#include "tests/shared/physics/shapes.h"

namespace platon::reflect_test {
namespace {

constexpr std::uint64_t kSeed = 20261128;
constexpr std::int32_t kFastest = kVelocityLimit - 1;
constexpr std::int32_t kLongest = kNormalLimit - 1;

TEST(ReflectTest, ReversesWhatLeadsAgainstTheNormal) {
  EXPECT_EQ(reflect({3, -5}, {0, 1}, 1, 1), Point(3, 5));
  EXPECT_EQ(reflect({3, -5}, {0, 700}, 1, 1), Point(3, 5)) << "only the direction counts";
  EXPECT_EQ(reflect({-10, 0}, {1, 1}, 1, 1), Point(0, 10));
  EXPECT_EQ(reflect({-10, 0}, {1, 1}, 0, 1), Point(-5, 5)) << "along the wall";
  EXPECT_EQ(reflect({-10, 0}, {3, 4}, 1, 1), Point(-3, 10)) << "(-2.8, 9.6)";
  EXPECT_EQ(reflect({0, -100}, {0, 5}, 3, 4), Point(0, 75));
}

TEST(ReflectTest, RoundsHalvesAwayFromZero) {
  EXPECT_EQ(reflect({3, -5}, {0, 1}, 1, 2), Point(3, 3)) << "2.5";
  EXPECT_EQ(reflect({3, 5}, {0, -1}, 1, 2), Point(3, -3)) << "-2.5";
  EXPECT_EQ(reflect({-5, 0}, {1, 1}, 0, 1), Point(-3, 3)) << "(-2.5, 2.5)";
  EXPECT_EQ(reflect({0, -1}, {0, 1}, 1, 3), Point(0, 0));
  EXPECT_EQ(reflect({0, -1}, {0, 1}, 2, 3), Point(0, 1));
}

// Two contacts of one tick with the same wall turned the velocity back into the wall.
TEST(ReflectTest, KeepsAVelocityThatDoesNotLeadAgainstTheNormal) {
  EXPECT_EQ(reflect({3, 5}, {0, 1}, 1, 1), Point(3, 5));
  EXPECT_EQ(reflect({3, 0}, {0, 1}, 1, 1), Point(3, 0));
  EXPECT_EQ(reflect({0, 0}, {1, 2}, 1, 1), Point(0, 0));
  const Point once = reflect({-700, -200}, {5, 3}, 1, 2);
  EXPECT_EQ(reflect(once, {5, 3}, 1, 2), once);
}

TEST(ReflectTest, HoldsAtTheLimits) {
  EXPECT_EQ(reflect({0, -kFastest}, {0, kLongest}, INT32_MAX, INT32_MAX), Point(0, kFastest));
  EXPECT_EQ(reflect({-kFastest, -kFastest}, {kLongest, kLongest}, INT32_MAX, INT32_MAX), Point(kFastest, kFastest));
  EXPECT_EQ(reflect({kFastest, kFastest}, {-kLongest, -kLongest}, 0, INT32_MAX), Point(0, 0));
  EXPECT_EQ(reflect({0, -kFastest}, {1, kLongest}, 0, 1), Point(0, 0)) << "nearly along the wall";
}

// By the definition, in 128 bits: the result is at most half a subunit off on each axis.
TEST(ReflectTest, IsTheNearestToTheExactValue) {
  using oracle::Wide;
  sim::SeededRandom random(kSeed);
  for (int i = 0; i < 20000; ++i) {
    const Point velocity = random.vector(i % 2 == 0 ? kFastest : 100);
    const Point normal = random.vector(i % 3 == 0 ? kLongest : 20);
    const auto d = static_cast<std::int32_t>(1 + random.below(i % 5 == 0 ? INT32_MAX : 9));
    const auto n = static_cast<std::int32_t>(random.below(static_cast<std::uint64_t>(d) + 1));
    if (normal == Point() || dot(velocity, normal) >= 0) continue;
    const Point result = reflect(velocity, normal, n, d);
    const Wide along = Wide{dot(velocity, normal)} * (Wide{n} + d);
    const Wide unit = Wide{squaredLength(normal)} * d;
    const auto isNearest = [&](std::int32_t before, std::int32_t part, std::int32_t after) {
      const Wide off = Wide{before} * unit - along * part - Wide{after} * unit;
      return 2 * off <= unit && -2 * off <= unit;
    };
    ASSERT_TRUE(isNearest(velocity.x, normal.x, result.x)) << "seed " << kSeed << ", round " << i;
    ASSERT_TRUE(isNearest(velocity.y, normal.y, result.y)) << "seed " << kSeed << ", round " << i;
  }
}

TEST(ReflectTest, RefusesValuesOutOfRange) {
  const std::string velocity = " is out of range: its coordinates must be below 2^28 in magnitude";
  EXPECT_EQ(refusal([] {
              (void)reflect({kFastest + 1, 0}, {0, 1}, 1, 1);
            }),
            "reflect: the velocity (268435456, 0)" + velocity);
  EXPECT_EQ(refusal([] {
              (void)reflect({0, INT32_MIN}, {0, 1}, 1, 1);
            }),
            "reflect: the velocity (0, -2147483648)" + velocity);
  const std::string normal =
      " is out of range: it must not be (0, 0), and its coordinates must be below 2^30 in magnitude";
  EXPECT_EQ(refusal([] { (void)reflect({1, 1}, {0, 0}, 1, 1); }), "reflect: the normal (0, 0)" + normal);
  EXPECT_EQ(refusal([] {
              (void)reflect({1, 1}, {0, -kLongest - 1}, 1, 1);
            }),
            "reflect: the normal (0, -1073741824)" + normal);
  const std::string restitution = " is out of range: it must be from 0 to 1, with a denominator above 0";
  EXPECT_EQ(refusal([] { (void)reflect({1, 1}, {0, 1}, 3, 2); }), "reflect: the restitution 3/2" + restitution);
  EXPECT_EQ(refusal([] { (void)reflect({1, 1}, {0, 1}, -1, 2); }), "reflect: the restitution -1/2" + restitution);
  EXPECT_EQ(refusal([] { (void)reflect({1, 1}, {0, 1}, 0, 0); }), "reflect: the restitution 0/0" + restitution);
  EXPECT_EQ(refusal([] { (void)reflect({1, 1}, {0, 1}, 0, -1); }), "reflect: the restitution 0/-1" + restitution);
}

class Bouncing : public Rules {
 public:
  void contact(Entity& entity, const Contact& contact) override {
    const Angle toHome = contact.segment.toHome;
    entity.setVelocity(reflect(rotate(entity.velocity(), -toHome), contact.normal, 1, 2), toHome);
  }
};

TEST(ReflectTest, ABallBouncesOffAFloorOfTwoSegments) {
  World world;
  addPart(world, 0, {{{-100, 0}, {0, 0}}, {{0, 0}, {100, 0}}});
  Entity entity(world, square(10));
  MapPart(world, 0).insert(entity, {0, 20}, Angle());
  entity.setVelocity({2, -40});
  Bouncing rules;
  world.solve(rules);
  EXPECT_EQ(entity.velocity(), Point(2, 20));
}

// The segment is in a part whose frame is rotated by 90° against that of the home part.
TEST(ReflectTest, ABallBouncesOffASegmentOfAnotherFrame) {
  World world;
  MapPart left(world, 1);
  left.warp({1000, -5000}, {1000, 5000}, 2, {5000, 0}, {-5000, 0});
  left.initialize();
  MapPart above(world, 2);
  above.line({-5000, 50}, {5000, 50});
  above.warp({-5000, 0}, {5000, 0}, 1, {1000, 5000}, {1000, -5000});
  above.initialize();
  Entity entity(world, square(10));
  left.insert(entity, {900, 0}, Angle());
  entity.setVelocity({300, 8});
  Bouncing rules;
  for (int tick = 0; tick < 2; ++tick) world.solve(rules);
  EXPECT_EQ(entity.part(), 1u);
  EXPECT_EQ(entity.velocity(), Point(-150, 8));
}

}  // namespace
}  // namespace platon::reflect_test
