// Shapes of 3 to 64 vertices, needles, and shapes with almost no area.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "platon/exact/integer.h"
#include "tests/exactness/hard_cases/checked_world.h"
#include "tests/exactness/step_check/run_length.h"
#include "tests/shared/physics/shapes.h"
#include "tests/sim/seeded_random.h"

namespace platon::hard_cases::shapes_test {
namespace {

constexpr std::uint64_t kSeed = 64;
constexpr std::int32_t kWall = 300000000;  // x of the wall of course.scene, whose floor is at y = 0

/// The scene file course.scene with another shape.
std::string courseWith(const Convex& shape) {
  std::string line = "shape";
  for (const Point vertex : shape.vertices()) line += " " + std::to_string(vertex.x) + " " + std::to_string(vertex.y);
  std::string text = readSceneFile("shapes/course.scene");
  const std::size_t begin = text.find("shape ", text.find('\n'));
  return text.replace(begin, text.find('\n', begin) - begin, line);
}

/// Expects that the shape falls onto the floor, slides to the wall and rests there, all at exact positions.
void expectCourse(HardScene& scene, const std::string& name) {
  const Box& box = scene.shape.bounds();
  scene.ticksUntilRest(scene.velocity, 100);
  EXPECT_EQ(scene.at(), Point(0, -box.low.y)) << name << " on the floor";
  const Point press(20000001, -777);
  scene.tick(press);
  EXPECT_EQ(scene.at(), Point(press.x, -box.low.y)) << name << " sliding on the floor";
  scene.ticksUntilRest(press, 100);
  EXPECT_EQ(scene.at(), Point(kWall - box.high.x, -box.low.y)) << name << " at the wall";
  for (int tick = 0; tick < 100; ++tick) scene.tick(press);
  EXPECT_EQ(scene.at(), Point(kWall - box.high.x, -box.low.y)) << name << " resting at the wall";
}

TEST(ShapesTest, ShapesOf3To64VerticesMoveExactly) {
  for (int vertices = 3; vertices <= 64; ++vertices) {
    for (const std::int32_t radius : {1000, 12288, 1 << 27}) {
      const std::string name = std::to_string(vertices) + " vertices, radius " + std::to_string(radius);
      HardScene scene(name, courseWith(regular(vertices, radius)));
      ASSERT_EQ(scene.shape.vertices().size(), static_cast<std::size_t>(vertices));
      expectCourse(scene, name);
    }
  }
}

const char* const kThinShapes[] = {"needle_1000", "needle_slanted", "needle_upright",
                                   "sliver",      "nearly_flat",    "nearly_square"};

TEST(ShapesTest, NeedlesAndSliversMoveExactly) {
  for (const char* name : kThinShapes) {
    HardScene scene(std::string("shapes/") + name + ".scene");
    expectCourse(scene, name);
  }
}

TEST(ShapesTest, InvariantsHoldAtRandomVelocities) {
  const std::int64_t ticks = step_check::runLength(300, 100000);
  for (const char* name : kThinShapes) {
    sim::SeededRandom random(kSeed);
    HardScene scene(std::string("shapes/") + name + ".scene");
    for (std::int64_t tick = 0; tick < ticks && scene.invariantsHold(); ++tick) {
      Point velocity = random.vector(std::int32_t{1} << random.below(28));
      // Keeps the shape near the walls.
      if (scene.at().x < -300000000) velocity.x = std::abs(velocity.x);
      if (scene.at().y > 300000000) velocity.y = -std::abs(velocity.y);
      scene.tick(velocity);
    }
    EXPECT_TRUE(scene.invariantsHold()) << name << ", seed " << kSeed;
  }
}

}  // namespace
}  // namespace platon::hard_cases::shapes_test
