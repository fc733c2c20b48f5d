// Paths that leave a line at next to no angle.
#include <gtest/gtest.h>

#include "platon/exact/fraction.h"
#include "tests/exactness/hard_cases/judged_world.h"
#include "tests/exactness/hard_cases/sweep_cases.h"

namespace platon::hard_cases {
namespace {

// For each power of ten from 1e-1 to 1e-15 radians: the corner touches the middle of the line at the end of its path;
// is farther from it, then nearer to it, by the least that a lattice can tell, about 1e-9 subunits; the same by a whole
// subunit.
TEST(GrazingTest, DownToTheLeastAngles) { EXPECT_EQ(expectAnswers("grazing/by_angle"), 15u * 5u); }

TEST(GrazingTest, ARiseOfOneIn200Millions) {
  HardScene scene("grazing/slope.scene");
  scene.tick(scene.velocity);
  ASSERT_EQ(scene.rules.contacts.size(), 1u);
  EXPECT_EQ(scene.rules.contacts[0].time, (Fraction{199999990, 200000000}));
  EXPECT_EQ(scene.rules.contacts[0].point, Point(0, 1));
  EXPECT_EQ(scene.at(), Point(-1, 12)) << "nine more subunits along the line, rounded to its outer side";
  scene.tick(scene.velocity);
  EXPECT_EQ(scene.at(), Point(199999999, 12)) << "above the whole of the line";
  EXPECT_TRUE(scene.rules.contacts.empty());
  scene.tick(-scene.velocity);
  scene.tick({-1, 0});
  EXPECT_EQ(scene.at(), Point(-2, 12)) << "and back";
}

TEST(GrazingTest, AnEndThatIsTouchedIsNoContact) {
  HardScene scene("grazing/touched_end.scene");
  for (int tick = 1; tick <= 2; ++tick) {
    scene.tick(scene.velocity);
    EXPECT_EQ(scene.at(), Point(tick * 199999990, 11));
  }
  for (int tick = 0; tick < 2; ++tick) scene.tick(-scene.velocity);
  EXPECT_EQ(scene.at(), Point(0, 11));
  EXPECT_TRUE(scene.rules.take().empty());
}

TEST(GrazingTest, ThroughTheNarrowEndOfANarrowingGap) {
  HardScene scene("grazing/narrowing.scene");
  for (int tick = 1; tick <= 4; ++tick) {
    scene.tick(scene.velocity);
    EXPECT_EQ(scene.at(), Point(-200000000 + tick * 100000000, 0));
  }
  for (int tick = 0; tick < 4; ++tick) scene.tick(-scene.velocity);
  EXPECT_EQ(scene.at(), Point(-200000000, 0));
  EXPECT_TRUE(scene.rules.take().empty());
}

// The upper line comes down by two subunits in 400 000 000: at x = 0 its distance from the axis is 10.
TEST(GrazingTest, NotThroughAGapThatIsOneSubunitTooNarrow) {
  HardScene scene("grazing/too_narrow.scene");
  EXPECT_LT(scene.ticksToRest(scene.velocity, 20), 20);
  EXPECT_EQ(scene.at(), Point(-10, 0)) << "the upper corner in front is on the line";
  for (int tick = 0; tick < 100; ++tick) scene.tick(scene.velocity);
  EXPECT_EQ(scene.at(), Point(-10, 0));
  scene.tick(-scene.velocity);
  EXPECT_EQ(scene.at(), Point(-10 - 100000000, 0));
}

}  // namespace
}  // namespace platon::hard_cases
