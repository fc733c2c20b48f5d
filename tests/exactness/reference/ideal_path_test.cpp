#include "tests/exactness/reference/ideal_path.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/exactness/reference/terrain.h"

namespace platon::reference::ideal_path_test {
namespace {

using oracle::Segment;
using oracle::Vec;
using Kind = IdealPath::Kind;

constexpr std::int64_t kTicks = 1200;

/// A scene with a box 2 wide and 2 high; its position is the middle of its bottom edge.
ExactScene box(std::vector<Segment> lines, Vec start, Vec velocity) {
  return {{{-1, 0}, {1, 0}, {1, 2}, {-1, 2}}, std::move(lines), start, velocity};
}

void expectAt(const IdealPath& path, std::int64_t tick, const char* x, const char* y) {
  EXPECT_EQ(path.positionAt(tick).x, mpq_class(x)) << "tick " << tick;
  EXPECT_EQ(path.positionAt(tick).y, mpq_class(y)) << "tick " << tick;
}

TEST(IdealPathTest, MovesStraightWithoutContact) {
  const IdealPath path(box({{{-9, -1}, {9, -1}}}, {0, 0}, {3, 5}), 2);
  expectAt(path, 0, "0", "0");
  expectAt(path, 1, "3", "5");
  expectAt(path, 2, "6", "10");
  EXPECT_EQ(path.legs().size(), 1u);
  EXPECT_FALSE(path.touchesBetween(0, 2));
}

TEST(IdealPathTest, SlidesOnALevelFloor) {
  const IdealPath path(box({{{-90, 0}, {90, 0}}}, {0, 1}, {7, -3}), 2);
  expectAt(path, 1, "7", "0");  // touches after a third, at 7/3
  expectAt(path, 2, "14", "0");
  ASSERT_EQ(path.legs().size(), 2u);
  EXPECT_EQ(path.legs()[1].begin, mpq_class("1/3"));
  EXPECT_TRUE(path.touchesBetween(0, 1));
}

TEST(IdealPathTest, ProjectsTheVelocityOnASlope) {
  // The vertex starts at (2, 3) and meets the slope at (2, 1) after half a tick. The projection of the velocity on
  // (2, 1) is -4/5 (2, 1).
  const IdealPath path(box({{{-90, -45}, {90, 45}}}, {1, 3}, {0, -4}), 2);
  expectAt(path, 1, "1/5", "3/5");
  expectAt(path, 2, "-7/5", "-1/5");
}

TEST(IdealPathTest, StopsBetweenAWallAndAFloor) {
  const IdealPath path(box({{{-90, 0}, {90, 0}}, {{4, -9}, {4, 9}}}, {0, 0}, {5, 0}), 2);
  expectAt(path, 1, "3", "0");
  expectAt(path, 2, "3", "0");
  EXPECT_EQ(path.legs().back().kind, Kind::kRest);
  EXPECT_EQ(path.legs().back().begin, mpq_class("3/5"));
}

TEST(IdealPathTest, MovesFreelyBeyondALedge) {
  // The left vertex leaves the floor after two thirds of the way; a third of (6, -3) then remains.
  const IdealPath path(box({{{-90, 0}, {3, 0}}}, {0, 0}, {6, -3}), 1);
  expectAt(path, 1, "6", "-1");
}

TEST(IdealPathTest, SlidesAroundAPoint) {
  // The bottom meets the point after half a tick. The left vertex passes it a quarter of a tick later.
  const IdealPath path(box({{{2, 1}, {2, 1}}}, {0, 3}, {4, -4}), 2);
  expectAt(path, 1, "4", "0");
  expectAt(path, 2, "8", "-4");
  ASSERT_EQ(path.legs().size(), 3u);
  EXPECT_EQ(path.legs()[2].begin, mpq_class("3/4"));
}

TEST(IdealPathTest, RestsInAWedge) {
  // Vertices at (-1, 0) and (1, 0) stand on y = -x - 1 and y = x - 1: symmetric, so the velocity points straight into
  // the wedge.
  for (const Vec start : {Vec{0, 2}, Vec{-3, 9}}) {
    for (const Vec velocity : {Vec{0, -5}, Vec{1, -5}}) {
      const IdealPath path(box({{{-90, 89}, {1, -2}}, {{-1, -2}, {90, 89}}}, start, velocity), 40);
      expectAt(path, 40, "0", "0");
      EXPECT_EQ(path.legs().back().kind, Kind::kRest);
    }
  }
}

/// The box slides down one segment and up the next, also if both are hit at once and whichever comes first.
TEST(IdealPathTest, PassesTheCornerOfTwoSegments) {
  for (const bool firstAtFirst : {false, true}) {
    std::vector<Segment> lines = {{{-20, 2}, {1, 0}}, {{1, 0}, {50, 7}}};
    if (!firstAtFirst) std::swap(lines[0], lines[1]);
    const IdealPath path(box(lines, {-8, 4}, {5, -1}), 6);
    EXPECT_EQ(path.legs().back().kind, Kind::kSlide);
    EXPECT_GT(path.positionAt(6).x, 9);
  }
}

TEST(IdealPathTest, ATouchIsNotAHit) {
  const IdealPath path(box({{{1, 0}, {9, 0}}}, {0, 4}, {0, -4}), 2);  // passes the end of the segment
  expectAt(path, 2, "0", "-4");
}

TEST(IdealPathTest, RefusesAStartInsideAnObstacle) {
  EXPECT_THROW(IdealPath(box({{{-9, 1}, {9, 1}}}, {0, 0}, {1, 0}), 1), std::runtime_error);
}

class IdealPathLawTest : public testing::TestWithParam<std::uint64_t> {
 protected:
  const ExactScene scene_ = randomTerrain(GetParam(), kTicks).scene;
  const IdealPath path_{scene_, kTicks};
};

/// The legs form a chain, up to the stated error of the times.
TEST_P(IdealPathLawTest, ALegEndsWhereTheNextOneBegins) {
  const mpq_class error(1, mpz_class(1) << 200);
  for (std::size_t i = 0; i + 1 < path_.legs().size(); ++i) {
    const IdealPath::Leg& leg = path_.legs()[i];
    const IdealPath::Leg& next = path_.legs()[i + 1];
    const mpq_class passed = next.begin - leg.begin;
    const RationalVec start = leg.start.rational();
    const RationalVec end = next.start.rational();
    EXPECT_GT(passed, 0);
    EXPECT_LT(abs(start.x + passed * leg.velocity.x - end.x), error);
    EXPECT_LT(abs(start.y + passed * leg.velocity.y - end.y), error);
    EXPECT_LE(mpz_sizeinbase(next.begin.get_den_mpz_t(), 2), IdealPath::kMaxTimeBits);
  }
}

TEST_P(IdealPathLawTest, ASlideIsTheProjectionOfTheVelocityOntoItsEdge) {
  for (const IdealPath::Leg& leg : path_.legs()) {
    if (leg.kind != Kind::kSlide) continue;
    const PathObstacle::Side& side = path_.side(leg.along);
    const RationalVec removed = {scene_.velocity.x - leg.velocity.x, scene_.velocity.y - leg.velocity.y};
    EXPECT_EQ(side.x * leg.velocity.x + side.y * leg.velocity.y, 0);                   // along the edge
    EXPECT_EQ(side.x * removed.y - side.y * removed.x, 0);                             // along its normal
    EXPECT_LT(side.x * removed.x + side.y * removed.y, 0);                             // and inwards
    EXPECT_EQ(side.x * leg.start.x + side.y * leg.start.y, side.bound * leg.start.d);  // on the edge
  }
}

TEST_P(IdealPathLawTest, TheBodyOverlapsNoSegment) {
  for (std::int64_t tick = 0; tick <= kTicks; ++tick) {
    const RationalVec at = path_.positionAt(tick);
    if (path_.legAt(mpq_class(tick)).kind != Kind::kFree) continue;  // on an edge only up to the error of the times
    EXPECT_TRUE(path_.isFree(
        {at.x.get_num() * at.y.get_den(), at.y.get_num() * at.x.get_den(), at.x.get_den() * at.y.get_den()}))
        << "tick " << tick;
  }
  for (const IdealPath::Leg& leg : path_.legs()) EXPECT_TRUE(path_.isFree(leg.start));
}

TEST_P(IdealPathLawTest, ThePathFromAPlaceOnItIsTheSame) {
  const IdealPath::Leg& middle = path_.legs()[path_.legs().size() / 2];
  const IdealPath rest = path_.from(middle.start, middle.begin, {});
  for (std::int64_t tick = kTicks - 100; tick <= kTicks; ++tick) {
    const RationalVec a = path_.positionAt(tick);
    const RationalVec b = rest.positionAt(tick);
    EXPECT_LT(abs(mpq_class(a.x - b.x)) + abs(mpq_class(a.y - b.y)), mpq_class(1, mpz_class(1) << 200));
  }
}

INSTANTIATE_TEST_SUITE_P(Terrains, IdealPathLawTest, testing::Range<std::uint64_t>(1, 21));

}  // namespace
}  // namespace platon::reference::ideal_path_test
