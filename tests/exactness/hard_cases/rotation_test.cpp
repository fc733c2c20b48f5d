// Turns that lines stop.
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "tests/exactness/hard_cases/judged_world.h"

namespace platon::hard_cases {
namespace {

/// A turn that `line` must stop; none: that nothing stops.
struct Turn {
  std::int32_t centidegrees;
  std::optional<std::uint32_t> line;
};

std::vector<std::string> touches(std::optional<std::uint32_t> line) {
  if (!line) return {};
  return {"touch 0:" + std::to_string(*line)};
}

// Ends at the last free angle: a centidegree farther is refused, and would not be free.
void expectTurn(const std::string& name, Turn turn) {
  SCOPED_TRACE(name + ", turn by " + std::to_string(turn.centidegrees));
  HardScene scene("rotation/" + name + ".scene");
  const Point start = scene.at();
  scene.entity().rotate(turn.centidegrees);
  scene.tick();
  const Angle stopped = scene.entity().rotation();
  EXPECT_EQ(scene.rules.take(), touches(turn.line));
  EXPECT_EQ(scene.at(), start) << "a turn moves nothing";
  if (!turn.line) {
    EXPECT_EQ(stopped, Angle(turn.centidegrees));
    return;
  }
  const std::int32_t unit = turn.centidegrees > 0 ? 1 : -1;
  EXPECT_TRUE(scene.checker.isFree(0, start, stopped));
  EXPECT_FALSE(scene.checker.isFree(0, start, stopped + Angle(unit))) << "at " << stopped.centidegrees();
  for (const std::int32_t again : {unit, 700 * unit}) {
    scene.entity().rotate(again);
    scene.tick();
    EXPECT_EQ(scene.entity().rotation(), stopped) << "again by " << again;
    EXPECT_EQ(scene.rules.take(), touches(turn.line)) << "again by " << again;
  }
  scene.entity().rotate(-stopped.centidegrees() + (unit > 0 || stopped == Angle() ? 0 : Angle::kTurn));
  scene.tick();
  EXPECT_EQ(scene.entity().rotation(), Angle()) << "back";
  EXPECT_TRUE(scene.rules.take().empty());
}

void expectTurns(const std::string& name, const std::vector<Turn>& turns) {
  for (const Turn& turn : turns) expectTurn(name, turn);
}

// The corners of the square are 14 142 from its middle, the line 11 500: free up to 45° - acos(11500 / 14142), 9.4°.
TEST(RotationTest, ByOneLine) {
  expectTurns("one_line", {{900, {}}, {-900, {}}, {1000, 0}, {-1000, 0}, {4500, 0}, {35999, 0}, {-35999, 0}});
}

TEST(RotationTest, ByTwoLines) { expectTurns("two_lines", {{900, {}}, {-300, {}}, {9000, 1}, {-9000, 0}}); }

TEST(RotationTest, ByAnEndInsideTheSweptArea) {
  expectTurns("end", {{3000, {}}, {9000, 0}, {17000, 0}, {-9000, {}}, {-12000, 0}, {-35000, 0}});
}

TEST(RotationTest, ByAPoint) { expectTurns("point", {{9000, {}}, {17000, 0}, {35999, 0}, {-1000, {}}, {-9000, 0}}); }

TEST(RotationTest, ByEndsOnBothSides) { expectTurns("between_ends", {{5, {}}, {9000, 1}, {-9000, {}}, {-18000, 0}}); }

TEST(RotationTest, NotAtAllInASlot) { expectTurns("slot", {{1, 0}, {-1, 0}, {18000, 0}}); }

TEST(RotationTest, OfAShapeFarFromItsOwnOrigin) { expectTurns("skew", {{1000, {}}, {9000, 0}, {-30000, 1}}); }

}  // namespace
}  // namespace platon::hard_cases
