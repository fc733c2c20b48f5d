#include "tests/sim/scene_file.h"

#include <gtest/gtest.h>

#include "platon/physics/entity.h"
#include "tests/sim/sim_options.h"

namespace platon::sim::scene_file_test {
namespace {

std::string faultsOf(std::string_view text) {
  try {
    loadScene("s", text);
  } catch (const InputError& reason) {
    return reason.what();
  }
  return "";
}

TEST(SceneTest, ReadsEveryWord) {
  const Scene scene = loadScene("s",
                                "# a scene\r\n"
                                "shape -10 -10 10 -10 10 10 -10 10   # a square\n\n"
                                "line -100 -50 100 -50\n"
                                "\tline 7 7 7 7\n"
                                "entity 0 40\nentity -60 0\n"
                                "velocity 3 -4");
  EXPECT_EQ(scene.shape.vertices().size(), 4u);
  EXPECT_EQ(scene.velocity, Point(3, -4));
  ASSERT_EQ(scene.world.entities().size(), 2u);
  EXPECT_EQ(scene.world.entities()[1].position, Point(-60, 0));
  ASSERT_EQ(scene.world.geometry().parts.size(), 1u);
  EXPECT_EQ(scene.world.geometry().parts[0]->id, 0u);
  EXPECT_EQ(scene.world.geometry().parts[0]->segments,
            (std::vector<Segment>{{{-100, -50}, {100, -50}}, {{7, 7}, {7, 7}}}));
}

TEST(SceneTest, TheDefaultVelocityIsZero) {
  EXPECT_EQ(loadScene("s", "shape 0 0 1 0 0 1\nentity 0 0\n").velocity, Point());
}

TEST(SceneTest, ReportsEveryErrorAtItsPosition) {
  const std::string valid = "shape 0 0 9 0 0 9\nentity 0 0\n";
  EXPECT_EQ(faultsOf(valid + "box 1 2"), "s:3:1: error: unknown word 'box': use shape, line, entity or velocity");
  EXPECT_EQ(faultsOf(valid + "  line 1 2 3"), "s:3:3: error: 'line' takes 4 numbers, not 3");
  EXPECT_EQ(faultsOf(valid + "line 1 2 3 4 5"), "s:3:1: error: 'line' takes 4 numbers, not 5");
  EXPECT_EQ(faultsOf(valid + "line 1 2 3 x4"), "s:3:12: error: 'x4' is not an integer below 2^29 in magnitude");
  EXPECT_EQ(faultsOf(valid + "line 1 2 3 536870912"),
            "s:3:12: error: '536870912' is not an integer below 2^29 in magnitude");
  EXPECT_EQ(faultsOf(valid + "line -100 2 -3 -536870911"), "");
  EXPECT_EQ(faultsOf(valid + "shape 0 0 9 0 0 9"), "s:3:1: error: second shape: remove one of them");
  EXPECT_EQ(faultsOf(valid + "velocity 1 2\nvelocity 1 2"), "s:4:1: error: second velocity: remove one of them");
  EXPECT_EQ(faultsOf(valid + "velocity 268435456 0"),
            "s:3:1: error: the velocity must be below 2^28 subunits per tick");
  EXPECT_EQ(faultsOf("shape 0 0 9 0 0\nentity 0 0"), "s:1:1: error: odd number of coordinates");
  EXPECT_EQ(faultsOf("shape 0 0 0 9 9 0\nentity 0 0"),
            "s:1:1: error: vertex 2 of 3, (0, 9), turns clockwise: a shape must be convex and counter-clockwise");
}

TEST(SceneTest, NeedsAShapeAndAnEntity) {
  EXPECT_EQ(faultsOf("entity 0 0\n"), "s:1:1: error: the scene has no shape: add a line 'shape x y x y …'");
  EXPECT_EQ(faultsOf("shape 0 0 9 0 0 9\n"), "s:1:1: error: the scene has no entity: add a line 'entity x y'");
  EXPECT_NE(faultsOf("").find("no shape"), std::string::npos);
}

TEST(SceneTest, ReportsAllErrors) {
  const std::string faults = faultsOf("line 1\nbox\nshape 0 0\n");
  EXPECT_NE(faults.find("s:1:1:"), std::string::npos);
  EXPECT_NE(faults.find("s:2:1:"), std::string::npos);
  EXPECT_NE(faults.find("s:3:1:"), std::string::npos);
}

TEST(SceneTest, RefusesAnEntityThatOverlapsALine) {
  EXPECT_EQ(faultsOf("shape 0 0 9 0 0 9\nline 1 1 2 2\nentity 50 50\nentity 0 0\n"),
            "s:4:1: error: entity 1 in map part 0: the shape overlaps a blocking segment");
}

}  // namespace
}  // namespace platon::sim::scene_file_test
