#include "tests/exactness/reference/exact_mover.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace platon::reference {
namespace {

using oracle::Segment;
using oracle::Vec;

/// A scene with a box 2 wide and 2 high; its position is the middle of its bottom edge.
ExactScene box(std::vector<Segment> lines, Vec start, Vec velocity) {
  return {{{-1, 0}, {1, 0}, {1, 2}, {-1, 2}}, std::move(lines), start, velocity};
}

void expectAt(const ExactMover& mover, const char* x, const char* y) {
  EXPECT_EQ(mover.position().x, mpq_class(x));
  EXPECT_EQ(mover.position().y, mpq_class(y));
}

TEST(ExactMoverTest, MovesStraightWithoutContact) {
  ExactMover mover(box({{{-9, -1}, {9, -1}}}, {0, 0}, {3, 5}));
  mover.tick();
  mover.tick();
  expectAt(mover, "6", "10");
  EXPECT_EQ(mover.legs(), 2u);
}

TEST(ExactMoverTest, SlidesOnALevelFloor) {
  ExactMover mover(box({{{-90, 0}, {90, 0}}}, {0, 1}, {7, -3}));
  mover.tick();  // touches after a third, at 7/3
  expectAt(mover, "7", "0");
  EXPECT_EQ(mover.legs(), 2u);
  mover.tick();
  expectAt(mover, "14", "0");
}

TEST(ExactMoverTest, ProjectsTheRemainingDisplacementOnASlope) {
  ExactMover mover(box({{{-90, -45}, {90, 45}}}, {1, 3}, {0, -4}));
  // The corner starts at (2, 3) and meets the slope at (2, 1) after half the way; (0, -2) remains, and its projection
  // on (2, 1) is -2/5 (2, 1).
  mover.tick();
  expectAt(mover, "1/5", "3/5");
}

TEST(ExactMoverTest, StopsBetweenAWallAndAFloor) {
  // The wall stops it on the floor: the projection of the remaining displacement on the wall is zero.
  ExactMover mover(box({{{-90, 0}, {90, 0}}, {{4, -9}, {4, 9}}}, {0, 0}, {5, 0}));
  mover.tick();
  expectAt(mover, "3", "0");
  mover.tick();
  expectAt(mover, "3", "0");
}

TEST(ExactMoverTest, MovesFreelyBeyondALedge) {
  // The left corner leaves the floor after two thirds of the way; a third of (6, -3) then remains.
  ExactMover mover(box({{{-90, 0}, {3, 0}}}, {0, 0}, {6, -3}));
  mover.tick();
  expectAt(mover, "6", "-1");
}

TEST(ExactMoverTest, SlidesAroundAPoint) {
  // Slides down the left side of a point until the corner is below it, then moves freely.
  ExactMover mover(box({{{2, 1}, {2, 1}}}, {0, 2}, {4, -4}));
  mover.tick();  // the lower right corner hits the point and slides down to it
  mover.tick();
  EXPECT_GT(mover.position().x, 0);
}

TEST(ExactMoverTest, RestsInAWedge) {
  // Corners at (-1, 0) and (1, 0) stand on y = -x - 1 and y = x - 1: symmetric, so the velocity points straight into
  // the wedge.
  ExactMover mover(box({{{-90, 89}, {1, -2}}, {{-1, -2}, {90, 89}}}, {0, 2}, {0, -5}));
  for (int i = 0; i < 3; ++i) {
    mover.tick();
    expectAt(mover, "0", "0");
  }
}

TEST(ExactMoverTest, RestsInAWedgeAtASlantedVelocity) {
  ExactMover mover(box({{{-90, 89}, {1, -2}}, {{-1, -2}, {90, 89}}}, {-3, 9}, {1, -5}));
  for (int i = 0; i < 20; ++i) mover.tick();
  expectAt(mover, "0", "0");
}

TEST(ExactMoverTest, ATouchAtTheEndIsNoHit) {
  ExactMover mover(box({{{-9, 0}, {9, 0}}}, {0, 4}, {1, -4}));
  mover.tick();
  expectAt(mover, "1", "0");
  EXPECT_EQ(mover.legs(), 1u);
}

TEST(ExactMoverTest, RefusesAStartInsideAnObstacle) {
  ExactMover mover(box({{{-9, 1}, {9, 1}}}, {0, 0}, {1, 0}));
  EXPECT_THROW(mover.tick(), std::runtime_error);
}

}  // namespace
}  // namespace platon::reference
