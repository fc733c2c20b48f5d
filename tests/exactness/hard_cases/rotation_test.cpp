// Rotations that segments stop.
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "tests/exactness/hard_cases/checked_world.h"

namespace platon::hard_cases::rotation_test {
namespace {

/// A rotation and the segment that must stop it; nothing if the rotation is free.
struct Rotation {
  std::int32_t centidegrees;
  std::optional<std::uint32_t> line;
};

std::vector<std::string> touches(std::optional<std::uint32_t> line) {
  if (!line) return {};
  return {"touch 0:" + std::to_string(*line)};
}

// Expects that the rotation ends at the last free angle: one centidegree more would overlap.
void expectRotation(const std::string& name, Rotation rotation) {
  SCOPED_TRACE(name + ", rotated by " + std::to_string(rotation.centidegrees));
  HardScene scene("rotation/" + name + ".scene");
  const Point start = scene.at();
  scene.entity().rotate(rotation.centidegrees);
  scene.tick();
  const Angle stopped = scene.entity().rotation();
  EXPECT_EQ(scene.rules.take(), touches(rotation.line));
  EXPECT_EQ(scene.at(), start) << "a rotation must not move the entity";
  if (!rotation.line) {
    EXPECT_EQ(stopped, Angle(rotation.centidegrees));
    return;
  }
  const std::int32_t unit = rotation.centidegrees > 0 ? 1 : -1;
  EXPECT_TRUE(scene.checker.isFree(0, start, stopped));
  EXPECT_FALSE(scene.checker.isFree(0, start, stopped + Angle(unit))) << "at " << stopped.centidegrees();
  for (const std::int32_t again : {unit, 700 * unit}) {
    scene.entity().rotate(again);
    scene.tick();
    EXPECT_EQ(scene.entity().rotation(), stopped) << "rotated again by " << again;
    EXPECT_EQ(scene.rules.take(), touches(rotation.line)) << "rotated again by " << again;
  }
  scene.entity().rotate(-stopped.centidegrees() + (unit > 0 || stopped == Angle() ? 0 : Angle::kTurn));
  scene.tick();
  EXPECT_EQ(scene.entity().rotation(), Angle()) << "rotated back";
  EXPECT_TRUE(scene.rules.take().empty());
}

void expectRotations(const std::string& name, const std::vector<Rotation>& rotations) {
  for (const Rotation& rotation : rotations) expectRotation(name, rotation);
}

// The vertices of the square are 14 142 subunits from its centre, the segment is 11 500: free up to
// 45° - acos(11500 / 14142) = 9.4°.
TEST(RotationTest, IsStoppedByOneSegment) {
  expectRotations("one_line", {{900, {}}, {-900, {}}, {1000, 0}, {-1000, 0}, {4500, 0}, {35999, 0}, {-35999, 0}});
}

TEST(RotationTest, IsStoppedByTwoSegments) {
  expectRotations("two_lines", {{900, {}}, {-300, {}}, {9000, 1}, {-9000, 0}});
}

TEST(RotationTest, IsStoppedByAnEndInsideTheSweptArea) {
  expectRotations("end", {{3000, {}}, {9000, 0}, {17000, 0}, {-9000, {}}, {-12000, 0}, {-35000, 0}});
}

TEST(RotationTest, IsStoppedByAPoint) {
  expectRotations("point", {{9000, {}}, {17000, 0}, {35999, 0}, {-1000, {}}, {-9000, 0}});
}

TEST(RotationTest, IsStoppedByEndsOnBothSides) {
  expectRotations("between_ends", {{5, {}}, {9000, 1}, {-9000, {}}, {-18000, 0}});
}

TEST(RotationTest, IsImpossibleInASlot) { expectRotations("slot", {{1, 0}, {-1, 0}, {18000, 0}}); }

TEST(RotationTest, WorksForAShapeFarFromItsOrigin) { expectRotations("skew", {{1000, {}}, {9000, 0}, {-30000, 1}}); }

}  // namespace
}  // namespace platon::hard_cases::rotation_test
