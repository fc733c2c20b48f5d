// A ball across an edge whose two instances hit their segments at exactly the same time: the contact of the home
// instance is reported.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "platon/exact/angle.h"
#include "platon/exact/integer.h"
#include "platon/game/solid.h"
#include "tests/exactness/hard_cases/checked_world.h"

namespace platon::hard_cases::equal_times_test {
namespace {

constexpr std::int32_t kUnit = kSubunitsPerUnit;
constexpr std::int32_t kHalfEdge = 240 * kUnit;
const std::string kLevel = "equal_times/stubs.level";

/// A placement of the ball across an edge of the hexahedron.
struct Placement {
  int face;
  int edge;
  std::int32_t inside;  // distance of the centre from the edge, subunits
  int side;             // 1: before the middle of the edge, -1: after it

  const PlatonicSolid::Neighbour& behind() const {
    return PlatonicSolid::of(SolidKind::kHexahedron).neighbour(face, edge);
  }
  Angle turn() const { return Angle::degrees(90 * edge); }
  /// Edge 0 is at the bottom; its direction is +x.
  Point position() const { return rotate(Point(-side * 150 * kUnit, -kHalfEdge + inside), turn()); }
  Point velocity() const { return rotate(Point(side * 200 * kUnit, 0), turn()); }
  std::string home() const { return std::to_string(face) + ":" + std::to_string(edge); }
  std::string adjacent() const { return std::to_string(behind().face) + ":" + std::to_string(behind().edge); }
};

template <class Visit>
void forEachPlacement(Visit&& visit) {
  for (int face = 0; face < 6; ++face) {
    for (int edge = 0; edge < 4; ++edge) {
      for (const std::int32_t inside : {0, 1, 512, 2300}) {
        for (const int side : {1, -1}) {
          SCOPED_TRACE("face " + std::to_string(face) + ", edge " + std::to_string(edge) + ", inside " +
                       std::to_string(inside) + ", side " + std::to_string(side));
          visit(Placement{face, edge, inside, side});
        }
      }
    }
  }
}

/// Time of the contact when this segment is pierceable, so that only the other instance is stopped.
Fraction timeOfContact(const Placement& placement, std::uint32_t part, std::uint32_t line) {
  RecordedRules rules;
  rules.pierceable = {{part, line}};
  HardLevel level(kLevel, rules);
  EXPECT_TRUE(level.place(static_cast<std::uint32_t>(placement.face), placement.position()));
  level.tick(placement.velocity());
  return level.rules.contacts.at(0).time;
}

TEST(EqualTimesTest, BothInstancesHitTheirSegmentsAtTheSameTime) {
  forEachPlacement([](const Placement& placement) {
    const auto edge = static_cast<std::uint32_t>(placement.edge);
    EXPECT_EQ(timeOfContact(placement, static_cast<std::uint32_t>(placement.face), edge),
              timeOfContact(placement, placement.behind().face, placement.behind().edge));
  });
}

TEST(EqualTimesTest, TheContactIsWithTheSegmentOfHome) {
  HardLevel level(kLevel);
  forEachPlacement([&](const Placement& placement) {
    ASSERT_TRUE(level.place(static_cast<std::uint32_t>(placement.face), placement.position()));
    level.tick(placement.velocity());
    std::vector<std::string> calls = level.rules.take();
    std::erase_if(calls, [](const std::string& call) { return !call.starts_with("contact"); });
    EXPECT_EQ(calls, std::vector<std::string>{"contact " + placement.home()});
    ASSERT_EQ(level.rules.contacts.size(), 1u);
    EXPECT_EQ(level.rules.contacts[0].segment.toHome, Angle());
    EXPECT_EQ(level.entity().part(), static_cast<std::uint32_t>(placement.face));
    // Its rightmost edge, vertical and 12 051 subunits from the centre, is on the segment.
    EXPECT_EQ(level.at(), rotate(Point(-placement.side * 12052, -kHalfEdge + placement.inside), placement.turn()));
    EXPECT_EQ(level.world.view(0).size(), 2u);
  });
}

TEST(EqualTimesTest, BeginAndEndContactAreCalledForTheHomeInstanceFirst) {
  RecordedRules rules;
  for (std::uint32_t face = 0; face < 6; ++face) {
    for (std::uint32_t line = 0; line < 4; ++line) rules.pierceable.insert({face, line});
  }
  HardLevel level(kLevel, rules);
  forEachPlacement([&](const Placement& placement) {
    ASSERT_TRUE(level.place(static_cast<std::uint32_t>(placement.face), placement.position()));
    level.tick({});
    level.rules.take();
    level.tick(placement.velocity());
    std::vector<std::string> calls = level.rules.take();
    // The ball always overlaps warp segments, which have the indices from 12, after stubs and posts.
    std::erase_if(calls, [](const std::string& call) { return call.starts_with("over"); });
    EXPECT_EQ(calls, (std::vector<std::string>{"begin " + placement.home(), "begin " + placement.adjacent(),
                                               "end " + placement.home(), "end " + placement.adjacent()}));
  });
}

}  // namespace
}  // namespace platon::hard_cases::equal_times_test
