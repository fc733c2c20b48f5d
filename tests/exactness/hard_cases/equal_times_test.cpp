// A ball across an edge whose two instances meet their lines at exactly the same time: home comes first.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "platon/exact/angle.h"
#include "platon/exact/integer.h"
#include "platon/game/solid.h"
#include "tests/exactness/hard_cases/judged_world.h"

namespace platon::hard_cases {
namespace {

constexpr std::int32_t kUnit = kSubunitsPerUnit;
constexpr std::int32_t kHalfEdge = 240 * kUnit;
const std::string kLevel = "equal_times/stubs.level";

/// Across an edge of the hexahedron, so far from it, and on which side of its middle.
struct Standing {
  int face;
  int edge;
  std::int32_t inside;  // subunits from the edge
  int side;             // 1: before its middle, -1: after it

  const PlatonicSolid::Neighbour& behind() const {
    return PlatonicSolid::of(SolidKind::kHexahedron).neighbour(face, edge);
  }
  Angle turn() const { return Angle::degrees(90 * edge); }
  /// Edge 0 is at the bottom and leads to the right.
  Point position() const { return rotate(Point(-side * 150 * kUnit, -kHalfEdge + inside), turn()); }
  Point velocity() const { return rotate(Point(side * 200 * kUnit, 0), turn()); }
  std::string home() const { return std::to_string(face) + ":" + std::to_string(edge); }
  std::string other() const { return std::to_string(behind().face) + ":" + std::to_string(behind().edge); }
};

template <class Visit>
void forEachStanding(Visit&& visit) {
  for (int face = 0; face < 6; ++face) {
    for (int edge = 0; edge < 4; ++edge) {
      for (const std::int32_t inside : {0, 1, 512, 2300}) {
        for (const int side : {1, -1}) {
          SCOPED_TRACE("face " + std::to_string(face) + ", edge " + std::to_string(edge) + ", inside " +
                       std::to_string(inside) + ", side " + std::to_string(side));
          visit(Standing{face, edge, inside, side});
        }
      }
    }
  }
}

/// The times of both instances alone, seen with the line of the other one pierceable.
Fraction timeOfContact(const Standing& standing, std::uint32_t part, std::uint32_t line) {
  RecordedRules rules;
  rules.pierceable = {{part, line}};
  HardLevel level(kLevel, rules);
  EXPECT_TRUE(level.place(static_cast<std::uint32_t>(standing.face), standing.position()));
  level.tick(standing.velocity());
  return level.rules.contacts.at(0).time;
}

TEST(EqualTimesTest, BothInstancesMeetTheirLinesAtTheSameTime) {
  forEachStanding([](const Standing& standing) {
    const auto edge = static_cast<std::uint32_t>(standing.edge);
    EXPECT_EQ(timeOfContact(standing, static_cast<std::uint32_t>(standing.face), edge),
              timeOfContact(standing, standing.behind().face, standing.behind().edge));
  });
}

TEST(EqualTimesTest, TheContactIsWithTheLineOfHome) {
  HardLevel level(kLevel);
  forEachStanding([&](const Standing& standing) {
    ASSERT_TRUE(level.place(static_cast<std::uint32_t>(standing.face), standing.position()));
    level.tick(standing.velocity());
    std::vector<std::string> calls = level.rules.take();
    std::erase_if(calls, [](const std::string& call) { return !call.starts_with("contact"); });
    EXPECT_EQ(calls, std::vector<std::string>{"contact " + standing.home()});
    ASSERT_EQ(level.rules.contacts.size(), 1u);
    EXPECT_EQ(level.rules.contacts[0].toHome, Angle());
    EXPECT_EQ(level.entity().part(), static_cast<std::uint32_t>(standing.face));
    // Its rightmost edge, upright and 12 051 subunits from the middle, is on the line.
    EXPECT_EQ(level.at(), rotate(Point(-standing.side * 12052, -kHalfEdge + standing.inside), standing.turn()));
    EXPECT_EQ(level.world.view(0).size(), 2u);
  });
}

TEST(EqualTimesTest, PierceableLinesBeginAndEndWithHomeFirst) {
  RecordedRules rules;
  for (std::uint32_t face = 0; face < 6; ++face) {
    for (std::uint32_t line = 0; line < 4; ++line) rules.pierceable.insert({face, line});
  }
  HardLevel level(kLevel, rules);
  forEachStanding([&](const Standing& standing) {
    ASSERT_TRUE(level.place(static_cast<std::uint32_t>(standing.face), standing.position()));
    level.tick({});
    level.rules.take();
    level.tick(standing.velocity());
    std::vector<std::string> calls = level.rules.take();
    // The warp lines, number 12 and following after the stubs and posts, are overlapped all the time.
    std::erase_if(calls, [](const std::string& call) { return call.starts_with("over"); });
    EXPECT_EQ(calls, (std::vector<std::string>{"begin " + standing.home(), "begin " + standing.other(),
                                               "end " + standing.home(), "end " + standing.other()}));
  });
}

}  // namespace
}  // namespace platon::hard_cases
