// Shapes of 3 to 64 corners, needles and shapes with next to no area.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "platon/exact/integer.h"
#include "tests/exactness/hard_cases/judged_world.h"
#include "tests/exactness/judge/run_length.h"
#include "tests/shared/physics/shapes.h"
#include "tests/sim/seeded_random.h"

namespace platon::hard_cases {
namespace {

constexpr std::uint64_t kSeed = 64;
constexpr std::int32_t kWall = 300000000;  // of the course: a floor at y = 0 that ends at a wall

/// The course with another shape.
std::string courseWith(const Convex& shape) {
  std::string line = "shape";
  for (const Point vertex : shape.vertices()) line += " " + std::to_string(vertex.x) + " " + std::to_string(vertex.y);
  std::string text = readCase("shapes/course.scene");
  const std::size_t begin = text.find("shape ", text.find('\n'));
  return text.replace(begin, text.find('\n', begin) - begin, line);
}

/// Falls on the floor, slides to the wall and stays: all exact, whatever the shape is.
void expectCourse(HardScene& scene, const std::string& name) {
  const Box& box = scene.shape.bounds();
  scene.ticksToRest(scene.velocity, 100);
  EXPECT_EQ(scene.at(), Point(0, -box.low.y)) << name << " falls on the floor";
  const Point press(20000001, -777);
  scene.tick(press);
  EXPECT_EQ(scene.at(), Point(press.x, -box.low.y)) << name << " slides on it";
  scene.ticksToRest(press, 100);
  EXPECT_EQ(scene.at(), Point(kWall - box.high.x, -box.low.y)) << name << " stops at the wall";
  for (int tick = 0; tick < 100; ++tick) scene.tick(press);
  EXPECT_EQ(scene.at(), Point(kWall - box.high.x, -box.low.y)) << name << " stays";
}

TEST(ShapesTest, Of3To64Corners) {
  for (int corners = 3; corners <= 64; ++corners) {
    for (const std::int32_t radius : {1000, 12288, 1 << 27}) {
      const std::string name = std::to_string(corners) + " corners, radius " + std::to_string(radius);
      HardScene scene(name, courseWith(regular(corners, radius)));
      ASSERT_EQ(scene.shape.vertices().size(), static_cast<std::size_t>(corners));
      expectCourse(scene, name);
    }
  }
}

const char* const kOddShapes[] = {"needle_1000", "needle_slanted", "needle_upright",
                                  "sliver",      "nearly_flat",    "nearly_square"};

TEST(ShapesTest, NeedlesAndSlivers) {
  for (const char* name : kOddShapes) {
    HardScene scene(std::string("shapes/") + name + ".scene");
    expectCourse(scene, name);
  }
}

TEST(ShapesTest, FlungAtTheWallsAllLawsHold) {
  const std::int64_t ticks = judge::runLength(300, 100000);
  for (const char* name : kOddShapes) {
    sim::SeededRandom random(kSeed);
    HardScene scene(std::string("shapes/") + name + ".scene");
    for (std::int64_t tick = 0; tick < ticks && scene.lawful(); ++tick) {
      Point velocity = random.vector(std::int32_t{1} << random.below(28));
      // Back towards the walls, lest it goes away for ever.
      if (scene.at().x < -300000000) velocity.x = std::abs(velocity.x);
      if (scene.at().y > 300000000) velocity.y = -std::abs(velocity.y);
      scene.tick(velocity);
    }
    EXPECT_TRUE(scene.lawful()) << name << ", seed " << kSeed;
  }
}

}  // namespace
}  // namespace platon::hard_cases
