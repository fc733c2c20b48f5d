#include "tests/exactness/reference/exact_mover.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace platon::reference {
namespace {

using oracle::Segment;
using oracle::Vec;

/// Two wide and two high, standing on its position.
ExactScene box(std::vector<Segment> lines, Vec start, Vec velocity) {
  return {{{-1, 0}, {1, 0}, {1, 2}, {-1, 2}}, std::move(lines), start, velocity};
}

void expectAt(const ExactMover& mover, const char* x, const char* y) {
  EXPECT_EQ(mover.position().x, mpq_class(x));
  EXPECT_EQ(mover.position().y, mpq_class(y));
}

TEST(ExactMoverTest, GoesStraightWhereNothingIsInTheWay) {
  ExactMover mover(box({{{-9, -1}, {9, -1}}}, {0, 0}, {3, 5}));
  mover.tick();
  mover.tick();
  expectAt(mover, "6", "10");
  EXPECT_EQ(mover.legs(), 2u);
}

TEST(ExactMoverTest, TouchesAndSlidesOnALevelFloor) {
  ExactMover mover(box({{{-90, 0}, {90, 0}}}, {0, 1}, {7, -3}));
  mover.tick();  // touches after a third, at 7/3
  expectAt(mover, "7", "0");
  EXPECT_EQ(mover.legs(), 2u);
  mover.tick();
  expectAt(mover, "14", "0");
}

TEST(ExactMoverTest, ProjectsWhatIsLeftOnASlope) {
  ExactMover mover(box({{{-90, -45}, {90, 45}}}, {1, 3}, {0, -4}));
  // The corner starts at (2, 3) and meets the slope at (2, 1) after half the way; (0, -2) is left, and its projection
  // on (2, 1) is -2/5 (2, 1).
  mover.tick();
  expectAt(mover, "1/5", "3/5");
}

TEST(ExactMoverTest, StopsWhereTheRestWouldLeadBackwards) {
  // Right against a wall while on the floor: nothing of (5, 0) is left along the wall.
  ExactMover mover(box({{{-90, 0}, {90, 0}}, {{4, -9}, {4, 9}}}, {0, 0}, {5, 0}));
  mover.tick();
  expectAt(mover, "3", "0");
  mover.tick();
  expectAt(mover, "3", "0");
}

TEST(ExactMoverTest, BeyondALedgeItFallsAsBefore) {
  // The left corner leaves the floor after two thirds of the way; a third of (6, -3) is then left.
  ExactMover mover(box({{{-90, 0}, {3, 0}}}, {0, 0}, {6, -3}));
  mover.tick();
  expectAt(mover, "6", "-1");
}

TEST(ExactMoverTest, RoundTheEndOfALineItGoesFromEdgeToEdge) {
  // Down along the left side of a point until the corner clears it, and on.
  ExactMover mover(box({{{2, 1}, {2, 1}}}, {0, 2}, {4, -4}));
  mover.tick();  // the lower right corner meets the point at once: half is used to slide down to its top
  mover.tick();
  EXPECT_GT(mover.position().x, 0);
}

TEST(ExactMoverTest, RestsInAWedge) {
  // Corners at (-1, 0) and (1, 0) stand on y = -x - 1 and y = x - 1: symmetric, so the drive is used up.
  ExactMover mover(box({{{-90, 89}, {1, -2}}, {{-1, -2}, {90, 89}}}, {0, 2}, {0, -5}));
  for (int i = 0; i < 3; ++i) {
    mover.tick();
    expectAt(mover, "0", "0");
  }
}

TEST(ExactMoverTest, WedgedAskewItStaysWhereBothEdgesHoldIt) {
  ExactMover mover(box({{{-90, 89}, {1, -2}}, {{-1, -2}, {90, 89}}}, {-3, 9}, {1, -5}));
  for (int i = 0; i < 20; ++i) mover.tick();
  expectAt(mover, "0", "0");
}

TEST(ExactMoverTest, AMeetingAtTheEndIsNone) {
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
