// Entities that touch a segment at the start of the tick.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "platon/exact/angle.h"
#include "platon/exact/fraction.h"
#include "platon/physics/entity_state.h"
#include "tests/exactness/hard_cases/checked_world.h"

namespace platon::hard_cases::touching_test {
namespace {

struct Push {
  Point velocity;
  Point moved;   // the expected displacement
  bool stopped;  // a contact at time 0 is expected
};

void expectMoves(const std::string& name, const std::vector<Push>& pushes) {
  for (const Push& push : pushes) {
    HardScene scene("touching/" + name + ".scene");
    const std::string what =
        name + ", velocity " + std::to_string(push.velocity.x) + " " + std::to_string(push.velocity.y);
    const Point start = scene.at();
    scene.tick(push.velocity);
    EXPECT_EQ(scene.at() - start, push.moved) << what;
    EXPECT_EQ(!scene.rules.contacts.empty(), push.stopped) << what;
    if (!push.stopped || scene.rules.contacts.empty()) continue;
    EXPECT_EQ(scene.rules.contacts.front().time, (Fraction{0, 1})) << what;
    EXPECT_LT(dot(scene.rules.contacts.front().normal, push.velocity), 0) << what;
  }
}

TEST(TouchingTest, MovesOnAFloor) {
  expectMoves("floor", {{{5, 3}, {5, 3}, false},
                        {{0, 1}, {0, 1}, false},
                        {{7, 0}, {7, 0}, false},
                        {{-100000, 0}, {-100000, 0}, false},
                        {{0, -5}, {0, 0}, true},
                        {{7, -5}, {7, 0}, true},
                        {{-1, -200000000}, {-1, 0}, true}});
}

TEST(TouchingTest, MovesInACorner) {
  expectMoves("corner", {{{5, -5}, {0, 0}, true},
                         {{5, 0}, {0, 0}, true},
                         {{0, -5}, {0, 0}, true},
                         {{200000000, -1}, {0, 0}, true},
                         {{-5, -5}, {-5, 0}, true},
                         {{5, 5}, {0, 5}, true},
                         {{-5, 0}, {-5, 0}, false},
                         {{0, 5}, {0, 5}, false},
                         {{-5, 5}, {-5, 5}, false}});
}

TEST(TouchingTest, MovesInAShaft) {
  expectMoves("shaft", {{{0, 7}, {0, 7}, false},
                        {{5, 7}, {0, 7}, true},
                        {{-5, -7}, {0, -7}, true},
                        {{5, 0}, {0, 0}, true},
                        {{-200000000, 0}, {0, 0}, true}});
}

// The slide along the slope ends at the lattice point that is nearest to its exact end and not below the slope.
TEST(TouchingTest, MovesOnASlope) {
  expectMoves("slope", {{{300, 100}, {300, 100}, false},
                        {{-300, -100}, {-300, -100}, false},
                        {{-1, 3}, {-1, 3}, false},
                        {{1, -3}, {0, 0}, true},
                        {{1000, -3000}, {0, 0}, true},
                        {{0, -90}, {-27, -9}, true},
                        {{6, -9}, {3, 1}, true},
                        {{100, 0}, {90, 30}, true}});
}

// If the exact contact is not a lattice point, the entity stops at a lattice point at most two steps away, on the free
// side. The slide is truncated to whole subunits. Truncating the displacement before the contact would often end beyond
// the slope.
TEST(TouchingTest, LandsOnASlopeAndSlides) {
  HardScene scene("touching/steeper.scene");
  for (const Point velocity : {Point(402, -670), Point(-401, -607), Point(-1000, -1399), Point(-503, -1900)}) {
    const double along = (5.0 * velocity.x + 3.0 * velocity.y) / 34;  // in units of the slope's (5, 3)
    for (std::int32_t i = 0; i < 400; ++i) {
      const Point start(i % 20 - 300, i / 20);
      WorldState placed = scene.world.save();
      placed.entities[0].position = start;
      scene.world.restore(placed);
      scene.tick(velocity);
      ASSERT_GE(scene.rules.contacts.size(), 1u);
      const Fraction time = scene.rules.contacts[0].time;
      const double part = static_cast<double>(time.numerator) / static_cast<double>(time.denominator);
      const double x = start.x + part * velocity.x + (1 - part) * along * 5;
      const double y = start.y + part * velocity.y + (1 - part) * along * 3;
      ASSERT_LE(std::hypot(scene.at().x - x, scene.at().y - y), 2.24 + 1.42)
          << velocity.x << " " << velocity.y << ", " << i;
      ASSERT_FALSE(scene.checker.isFree(0, scene.at() - Point(0, 3), Angle())) << "not on the slope";
    }
  }
}

TEST(TouchingTest, MovesOnTheEndOfASegment) {
  expectMoves("end", {{{0, -5}, {0, 0}, true},
                      {{5, -5}, {5, 0}, true},
                      {{5, 3}, {5, 3}, false},
                      {{-50, 0}, {-50, 0}, false},
                      {{50, 0}, {50, 0}, false}});
}

// A vertex on a point enters both edges at once. The contact is the edge with the smaller index, which rises to the
// right.
TEST(TouchingTest, MovesWithAVertexOnAPoint) {
  expectMoves("point", {{{0, -50}, {-25, -25}, true},
                        {{-50, -50}, {-50, -50}, false},
                        {{50, -50}, {50, -50}, false},
                        {{1, 0}, {1, 0}, false},
                        {{0, 50}, {0, 50}, false}});
}

// The segment leads away from the vertex, halfway between its edges. The bottom edge has the smaller index.
TEST(TouchingTest, MovesWithAVertexOnTheEndOfASegment) {
  expectMoves("end_at_corner", {{{50, 0}, {50, 0}, false},
                                {{0, -50}, {0, -50}, false},
                                {{-50, -50}, {-50, -50}, false},
                                {{50, 50}, {50, 50}, false},
                                {{50, -50}, {50, 0}, true},
                                {{10, -50}, {0, -50}, true}});  // the edge at the smaller angle
}

}  // namespace
}  // namespace platon::hard_cases::touching_test
