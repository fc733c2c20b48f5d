// Paths that are nearly parallel to a segment.
#include <gtest/gtest.h>

#include "platon/exact/fraction.h"
#include "tests/exactness/hard_cases/checked_world.h"
#include "tests/exactness/hard_cases/sweep_cases.h"

namespace platon::hard_cases::grazing_test {
namespace {

// For each power of ten from 1e-1 to 1e-15 radians, five queries. At the end of its path the vertex touches the middle
// of the segment; it is farther or nearer by the smallest distance on the lattice, about 1e-9 subunits; it is farther
// or nearer by one subunit.
TEST(GrazingTest, SweepsAtTheSmallestAnglesAreExact) { EXPECT_EQ(expectAnswers("grazing/by_angle"), 15u * 5u); }

// The segment is 2.5e-8 subunits above the corner at the end of the first tick: less than the ideal path resolves, but
// the position keeps clear of it.
TEST(GrazingTest, SlidesUpASlopeOfOneIn200Million) {
  HardScene scene("grazing/slope.scene");
  scene.tick(scene.velocity);
  EXPECT_TRUE(scene.rules.contacts.empty());
  EXPECT_EQ(scene.at(), Point(0, 12)) << "not overlapping";
  scene.tick(scene.velocity);
  ASSERT_EQ(scene.rules.contacts.size(), 1u);
  EXPECT_EQ(scene.rules.contacts[0].time, (Fraction{0, 1}));
  EXPECT_EQ(scene.rules.contacts[0].point, Point(10, 2)) << "the corner at the position";
  EXPECT_EQ(scene.at(), Point(200000000, 12)) << "half a subunit above the segment";
  scene.tick(-scene.velocity);
  EXPECT_TRUE(scene.rules.contacts.empty());
  EXPECT_EQ(scene.at(), Point(0, 12)) << "after moving back";
}

TEST(GrazingTest, ATouchedEndIsNotAContact) {
  HardScene scene("grazing/touched_end.scene");
  for (int tick = 1; tick <= 2; ++tick) {
    scene.tick(scene.velocity);
    EXPECT_EQ(scene.at(), Point(tick * 199999990, 11));
  }
  for (int tick = 0; tick < 2; ++tick) scene.tick(-scene.velocity);
  EXPECT_EQ(scene.at(), Point(0, 11));
  EXPECT_TRUE(scene.rules.take().empty());
}

TEST(GrazingTest, PassesANarrowingGapOfItsOwnWidth) {
  HardScene scene("grazing/narrowing.scene");
  for (int tick = 1; tick <= 4; ++tick) {
    scene.tick(scene.velocity);
    EXPECT_EQ(scene.at(), Point(-200000000 + tick * 100000000, 0));
  }
  for (int tick = 0; tick < 4; ++tick) scene.tick(-scene.velocity);
  EXPECT_EQ(scene.at(), Point(-200000000, 0));
  EXPECT_TRUE(scene.rules.take().empty());
}

// The upper segment descends by two subunits in 400 000 000: at x = 0 its distance from the axis is 10.
TEST(GrazingTest, IsStoppedByAGapOneSubunitTooNarrow) {
  HardScene scene("grazing/too_narrow.scene");
  EXPECT_LT(scene.ticksUntilRest(scene.velocity, 20), 20);
  EXPECT_EQ(scene.at(), Point(-10, 0)) << "the upper front vertex is on the segment";
  for (int tick = 0; tick < 100; ++tick) scene.tick(scene.velocity);
  EXPECT_EQ(scene.at(), Point(-10, 0));
  scene.tick(-scene.velocity);
  EXPECT_EQ(scene.at(), Point(-10 - 100000000, 0));
}

}  // namespace
}  // namespace platon::hard_cases::grazing_test
