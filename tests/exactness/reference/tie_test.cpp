#include "tests/exactness/reference/tie.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "tests/exactness/reference/simulated_body.h"
#include "tests/exactness/reference/terrain.h"

namespace platon::reference::tie_test {
namespace {

using oracle::Segment;
using oracle::Vec;
using Kind = Tie::Kind;

constexpr std::int64_t kTicks = 300;

Tie tieOf(const ExactScene& scene) { return findTie(scene, IdealPath(scene, kTicks), kTicks); }

/// A diamond that falls onto a point `beside` its lower vertex, high above a floor.
ExactScene diamond(std::int64_t beside) {
  return {{{0, -1000}, {1000, 0}, {0, 1000}, {-1000, 0}},
          {{{beside, -5000}, {beside, -5000}}, {{-90000, -60000}, {90000, -60000}}},
          {0, 0},
          {0, -400}};
}

/// A box 2000 wide and high among segments.
ExactScene box(std::vector<Segment> lines, Vec velocity) {
  return {{{-1000, 0}, {1000, 0}, {1000, 2000}, {-1000, 2000}}, std::move(lines), {0, 1000}, velocity};
}

TEST(TieTest, AVertexThatDividesThePathIsATie) { EXPECT_EQ(tieOf(diamond(0)).kind, Kind::kDivided); }

TEST(TieTest, AVertexOneSubunitAwayIsNoTie) {
  EXPECT_EQ(tieOf(diamond(1)).kind, Kind::kNone);
  EXPECT_EQ(tieOf(diamond(-1)).kind, Kind::kNone);
}

TEST(TieTest, AVertexThatTouchesTheFlankIsATie) {
  EXPECT_EQ(tieOf(diamond(1000)).kind, Kind::kNone);  // slides along its corner and back to its own path
  const auto ledge = [](std::int64_t x) {
    return box({{{x, -5000}, {9000, -5000}}, {{-90000, -60000}, {90000, -60000}}}, {0, -400});
  };
  EXPECT_EQ(tieOf(ledge(1000)).kind, Kind::kDivided);
  EXPECT_EQ(tieOf(ledge(1001)).kind, Kind::kNone);  // passes
  EXPECT_EQ(tieOf(ledge(999)).kind, Kind::kNone);   // rests on it
}

TEST(TieTest, AnOverhangThatTouchesTheBodyIsATie) {
  const auto passage = [](std::int64_t height) {
    return box({{{-9000, 0}, {900000, 0}}, {{9000, height}, {20000, height}}}, {300, -100});
  };
  EXPECT_EQ(tieOf(passage(2000)).kind, Kind::kDivided);
  EXPECT_EQ(tieOf(passage(2001)).kind, Kind::kNone);
  EXPECT_EQ(tieOf(passage(1999)).kind, Kind::kNone);  // stops there
}

TEST(TieTest, ARestAtAnEndThatProtrudesIsATieAtAJoint) {
  const auto floor = [](std::int64_t protrusion) {
    return box({{{-9000, 0}, {9000, 0}}, {{9001, protrusion}, {90000, 0}}}, {300, -300});
  };
  const Tie tie = tieOf(floor(1));
  EXPECT_EQ(tie.kind, Kind::kJoint);
  EXPECT_NEAR(tie.tick, 8001 / 300.0, 1e-9);  // the front of the box is at the end
  EXPECT_EQ(tieOf(floor(7)).kind, Kind::kJoint);
  EXPECT_EQ(tieOf(floor(8)).kind, Kind::kNone);
  EXPECT_EQ(tieOf(floor(0)).kind, Kind::kNone);
  EXPECT_EQ(tieOf(floor(9)).kind, Kind::kNone);  // a step that stops it for good
}

TEST(TieTest, ARestAtAnEndThatStandsAloneIsNoTie) {
  EXPECT_EQ(tieOf(box({{{-9000, 0}, {9000, 0}}, {{8000, 1}, {8000, 1}}}, {300, -300})).kind, Kind::kJoint);
  EXPECT_EQ(tieOf(box({{{-9000, 0}, {9000, 0}}, {{8000, 8}, {8000, 8}}}, {300, -300})).kind, Kind::kNone);
}

/// The flank of the body is almost perpendicular to the velocity, so it slides over the end at 1/300 of the speed.
TEST(TieTest, ASlideOverAnEndThatAlmostStopsTheBodyIsATieAtAJoint) {
  ExactScene scene = box({{{-9000, 0}, {9000, 0}}, {{9001, 2}, {90000, 0}}}, {300, -100});
  scene.shape = {{-1000, 1000}, {-500, 0}, {500, 0}, {837, 1000}, {0, 2000}};
  EXPECT_EQ(tieOf(scene).kind, Kind::kJoint);
}

TEST(TieTest, AnEndThatTheBodySlidesOverIsNoTie) {
  ExactScene scene = box({{{-9000, 0}, {9000, 0}}, {{9001, 2}, {90000, 0}}}, {300, -100});
  scene.shape = {{-1000, 1000}, {-500, 0}, {500, 0}, {1000, 1000}, {0, 2000}};
  EXPECT_EQ(tieOf(scene).kind, Kind::kNone);
}

TEST(TieTest, AFirmRestIsNoTie) {
  EXPECT_EQ(tieOf(box({{{-9000, 0}, {9000, 0}}, {{8000, -10}, {8000, 9000}}}, {300, -100})).kind, Kind::kNone);
  EXPECT_EQ(tieOf(box({{{-9000, 0}, {9000, 0}}}, {0, -100})).kind, Kind::kNone);
}

/// A larger body rests by the same rule.
TEST(TieTest, ARestAtLessThanOneSubunitATickIsNoTie) {
  EXPECT_EQ(tieOf(box({{{-9000, -6}, {9000, 6}}}, {0, -1400})).kind, Kind::kNone);
}

/// The middle of a wedge of 2 degrees is free only far above its tip.
TEST(TieTest, ARestFarFromEveryFreeLatticePointIsNarrow) {
  ExactScene scene = {{{0, 0}, {10, 2000}, {-10, 2000}}, {}, {0, 30000}, {0, -400}};
  scene.lines = {{{0, 0}, {1000, 50001}}, {{1, 0}, {-1000, 50001}}};
  EXPECT_EQ(tieOf(scene).kind, Kind::kNarrow);
}

TEST(TieTest, ASlideOverManyCornersIsNoTie) {
  std::vector<Segment> lines;
  for (std::int64_t x = -9000, i = 0; x < 90000; x += 3000, ++i) {
    lines.push_back({{x, i % 2 * 300}, {x + 3000, (i + 1) % 2 * 300}});
  }
  EXPECT_EQ(tieOf(box(lines, {200, -100})).kind, Kind::kNone);
}

/// What a tie excludes: that a body a little beside its ideal path ends elsewhere. Here already by two subunits.
TEST(TieTest, WithoutATieNoMoveByTwoSubunitsLeadsElsewhere) {
  int paths = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const ExactScene scene = randomTerrain(seed, kTicks).scene;
    const IdealPath ideal(scene, kTicks);
    if (findTie(scene, ideal, kTicks).kind != Kind::kNone) continue;
    const RationalVec end = ideal.positionAt(kTicks);
    for (const IdealPath::Leg& leg : ideal.legs()) {
      for (const Vec by : {Vec{2, 0}, Vec{-2, 0}, Vec{0, 2}, Vec{0, -2}}) {
        const Place beside = {leg.start.x + by.x * leg.start.d, leg.start.y + by.y * leg.start.d, leg.start.d};
        if (!ideal.isFree(beside)) continue;
        const RationalVec other = ideal.from(beside, leg.begin, {}).positionAt(kTicks);
        EXPECT_LE(distance(end, other), kSeparation) << "seed " << seed << ", tick " << leg.begin.get_d();
        ++paths;
      }
    }
  }
  EXPECT_GT(paths, 300);
}

}  // namespace
}  // namespace platon::reference::tie_test
