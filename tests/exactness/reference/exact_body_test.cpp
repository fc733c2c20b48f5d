#include "tests/exactness/reference/exact_body.h"

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

void expectAt(const ExactBody& body, const char* x, const char* y) {
  EXPECT_EQ(body.position().x, mpq_class(x));
  EXPECT_EQ(body.position().y, mpq_class(y));
}

TEST(ExactBodyTest, MovesStraightWithoutContact) {
  ExactBody body(box({{{-9, -1}, {9, -1}}}, {0, 0}, {3, 5}));
  body.tick();
  body.tick();
  expectAt(body, "6", "10");
  EXPECT_EQ(body.legs(), 2u);
}

TEST(ExactBodyTest, SlidesOnALevelFloor) {
  ExactBody body(box({{{-90, 0}, {90, 0}}}, {0, 1}, {7, -3}));
  body.tick();  // touches after a third, at 7/3
  expectAt(body, "7", "0");
  EXPECT_EQ(body.legs(), 2u);
  body.tick();
  expectAt(body, "14", "0");
}

TEST(ExactBodyTest, ProjectsTheRemainingDisplacementOnASlope) {
  ExactBody body(box({{{-90, -45}, {90, 45}}}, {1, 3}, {0, -4}));
  // The vertex starts at (2, 3) and meets the slope at (2, 1) after half the way; (0, -2) remains, and its projection
  // on (2, 1) is -2/5 (2, 1).
  body.tick();
  expectAt(body, "1/5", "3/5");
}

TEST(ExactBodyTest, StopsBetweenAWallAndAFloor) {
  // The wall stops it on the floor: the projection of the remaining displacement on the wall is zero.
  ExactBody body(box({{{-90, 0}, {90, 0}}, {{4, -9}, {4, 9}}}, {0, 0}, {5, 0}));
  body.tick();
  expectAt(body, "3", "0");
  body.tick();
  expectAt(body, "3", "0");
}

TEST(ExactBodyTest, MovesFreelyBeyondALedge) {
  // The left vertex leaves the floor after two thirds of the way; a third of (6, -3) then remains.
  ExactBody body(box({{{-90, 0}, {3, 0}}}, {0, 0}, {6, -3}));
  body.tick();
  expectAt(body, "6", "-1");
}

TEST(ExactBodyTest, SlidesAroundAPoint) {
  // Slides down the left side of a point until the vertex is below it, then moves freely.
  ExactBody body(box({{{2, 1}, {2, 1}}}, {0, 2}, {4, -4}));
  body.tick();  // the lower right vertex hits the point and slides down to it
  body.tick();
  EXPECT_GT(body.position().x, 0);
}

TEST(ExactBodyTest, RestsInAWedge) {
  // Vertices at (-1, 0) and (1, 0) stand on y = -x - 1 and y = x - 1: symmetric, so the velocity points straight into
  // the wedge.
  ExactBody body(box({{{-90, 89}, {1, -2}}, {{-1, -2}, {90, 89}}}, {0, 2}, {0, -5}));
  for (int i = 0; i < 3; ++i) {
    body.tick();
    expectAt(body, "0", "0");
  }
}

TEST(ExactBodyTest, RestsInAWedgeAtASlantedVelocity) {
  ExactBody body(box({{{-90, 89}, {1, -2}}, {{-1, -2}, {90, 89}}}, {-3, 9}, {1, -5}));
  for (int i = 0; i < 20; ++i) body.tick();
  expectAt(body, "0", "0");
}

TEST(ExactBodyTest, ATouchAtTheEndIsNotAHit) {
  ExactBody body(box({{{-9, 0}, {9, 0}}}, {0, 4}, {1, -4}));
  body.tick();
  expectAt(body, "1", "0");
  EXPECT_EQ(body.legs(), 1u);
}

TEST(ExactBodyTest, RefusesAStartInsideAnObstacle) {
  ExactBody body(box({{{-9, 1}, {9, 1}}}, {0, 0}, {1, 0}));
  EXPECT_THROW(body.tick(), std::runtime_error);
}

}  // namespace
}  // namespace platon::reference
