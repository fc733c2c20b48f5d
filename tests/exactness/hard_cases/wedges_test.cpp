// Moves into wedges at up to 2^28 subunits per tick.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "platon/exact/angle.h"
#include "platon/exact/integer.h"
#include "tests/exactness/hard_cases/checked_world.h"

namespace platon::hard_cases::wedges_test {
namespace {

/// True if the shape is inside the wedge. The apex is at the origin; segment 0 leaves it on the left and segment 1
/// returns to it on the right.
bool isInside(const HardScene& scene) {
  const auto& lines = scene.world.geometry().parts[0]->segments;
  const Point left = lines[0].b;
  const Point right = lines[1].a;
  for (const Point vertex : scene.shape.vertices()) {
    const Point corner = scene.at() + vertex;
    if (cross(left, corner) > 0 || cross(right, corner) < 0) return false;
  }
  return true;
}

/// Changes of the velocity in the scene file: how often it is halved, and its rotation.
struct Drive {
  int halvings;
  std::int32_t rotation;  // centidegrees
};

const Drive kDrives[] = {{0, 0}, {0, 1}, {0, -7}, {0, 1500}, {0, -3000}, {3, 0}, {3, 400}, {7, 0}, {7, -13}};

void driveInto(const std::string& name, Drive drive) {
  HardScene scene("wedges/" + name + ".scene");
  const Point whole = rotate(scene.velocity, Angle(drive.rotation));
  const Point velocity(whole.x >> drive.halvings, whole.y >> drive.halvings);
  constexpr int kMaxTicks = 2000;
  int ticks = 0;
  for (Point before(0, 0); before != scene.at() && ticks < kMaxTicks; ++ticks) {
    before = scene.at();
    scene.tick(velocity);
    ASSERT_TRUE(isInside(scene)) << "tick " << ticks << ", at " << scene.at().x << " " << scene.at().y;
  }
  ASSERT_LT(ticks, kMaxTicks) << "does not come to rest";
  const Point rest = scene.at();
  for (int tick = 0; tick < 1000 && scene.invariantsHold(); ++tick) scene.tick(velocity);
  EXPECT_EQ(scene.at(), rest);
  scene.tick(-velocity);
  EXPECT_GT(squaredLength(scene.at() - rest), squaredLength(Point(velocity.x / 2, velocity.y / 2)) / 4)
      << "does not move out of the wedge";
}

TEST(WedgesTest, NothingPassesTheApex) {
  for (const char* kind : {"symmetric", "rotated", "steep"}) {
    for (const char* degrees : {"10", "1", "0_1", "0_01"}) {
      for (const Drive& drive : kDrives) {
        const std::string name = std::string(kind) + "_" + degrees;
        SCOPED_TRACE(name + ", halved " + std::to_string(drive.halvings) + " times, rotated by " +
                     std::to_string(drive.rotation));
        driveInto(name, drive);
      }
    }
  }
}

// Moving straight into a symmetric wedge, the shape stops less than one subunit before it touches both segments.
TEST(WedgesTest, MovesIntoAWedgeAsFarAsItFits) {
  for (const char* degrees : {"10", "1", "0_1", "0_01"}) {
    HardScene scene(std::string("wedges/symmetric_") + degrees + ".scene");
    scene.ticksUntilRest(scene.velocity, 20);
    EXPECT_EQ(scene.at().y, 0);
    const Point rest = scene.at();
    EXPECT_TRUE(scene.checker.isFree(0, rest, Angle()));
    EXPECT_FALSE(scene.checker.isFree(0, rest - Point(1, 0), Angle())) << degrees;
  }
}

}  // namespace
}  // namespace platon::hard_cases::wedges_test
