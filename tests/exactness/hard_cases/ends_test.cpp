// Ends of lines against corners of shapes.
#include <gtest/gtest.h>

#include <cstdlib>

#include "platon/exact/fraction.h"
#include "tests/exactness/hard_cases/judged_world.h"
#include "tests/exactness/hard_cases/sweep_cases.h"

namespace platon::hard_cases {
namespace {

// A square that stands on its corner goes to the right; lines of many directions end at its leading corner, one subunit
// beside it, and at its flanks.
TEST(EndsTest, ASquareOnItsCorner) {
  EXPECT_EQ(expectAnswers("ends/small"), 28u);
  EXPECT_EQ(expectAnswers("ends/far"), 28u) << "the same more than a million times as large, off by one subunit still";
}

// Tip on end, both edges of the tip are entered at once: the earlier one of the shape decides. Here it leads up to the
// left, so that the mover slides off below the line: 1 000 aside and on, where the edge ends, and one subunit more.
// Aside and on is half of what it wants, so that these 1 001 take 2 002; the rest goes straight on.
TEST(EndsTest, StraightAtTheEndTheEarlierEdgeDecides) {
  HardScene scene("ends/straight.scene");
  scene.tick(scene.velocity);
  ASSERT_EQ(scene.rules.contacts.size(), 1u);
  const Contact contact = scene.rules.contacts[0];
  EXPECT_EQ(contact.point, Point(50000, 0));
  EXPECT_EQ(contact.time, (Fraction{49, 100}));
  EXPECT_EQ(contact.normal, Point(-1000, -1000));
  EXPECT_EQ(scene.at(), Point(49000 + 1001 + (51000 - 2002), -1001));
  const Point before = scene.at();
  scene.tick(scene.velocity);
  EXPECT_EQ(scene.at(), before + scene.velocity) << "beside the line";
  for (int back = 0; back < 2; ++back) scene.tick(-scene.velocity);
  EXPECT_EQ(scene.at(), before - scene.velocity);
  EXPECT_EQ(scene.rules.take().size(), 1u) << "nothing else was in the way";
}

// After four ticks the tip is at the end. It slides off along the long edge (30 040, 11 900), and one subunit more:
// that is 0.6 of the (50 066, 19 833) that the tick has along the edge. The 0.4 of the displacement that are left go
// straight on, and so does all that follows, beside the line.
TEST(EndsTest, ANeedlesTipSlidesOff) {
  HardScene scene("ends/slanted.scene");
  for (int tick = 0; tick < 4; ++tick) scene.tick(scene.velocity);
  EXPECT_EQ(scene.at(), Point(200000, 80000));
  EXPECT_TRUE(scene.rules.take().empty());
  scene.tick(scene.velocity);
  EXPECT_EQ(scene.rules.contacts.at(0).point, Point(230000, 92000));
  EXPECT_EQ(scene.at(), Point(200000, 80000) + Point(30041, 11900) + Point(50000 - 30001, 20000 - 12000));
  const Point before = scene.at();
  for (int tick = 0; tick < 5; ++tick) scene.tick(scene.velocity);
  EXPECT_EQ(scene.at(), before + Point(5 * scene.velocity.x, 5 * scene.velocity.y));
}

TEST(EndsTest, StraightAtTheEndFarAway) {
  HardScene scene("ends/straight_far.scene");
  scene.tick(scene.velocity);
  EXPECT_EQ(scene.rules.contacts.at(0).point, Point(200000000, 0));
  EXPECT_EQ(scene.rules.contacts.at(0).time, (Fraction{249000000, 268435455}));
  constexpr std::int32_t left = 268435455 - 249000000;
  constexpr std::int32_t edge = 1000000 + 1;
  EXPECT_EQ(scene.at(), Point(199000000 + edge + (left - 2 * edge), -edge)) << "a thousand times as large";
}

// A subunit beside the tip it slides off along an edge that is 999 long from there, and one subunit more: these take
// 2 000 of the 50 999 that are left.
TEST(EndsTest, OneSubunitAsideItSlidesOff) {
  HardScene above("ends/one_above.scene");
  HardScene below("ends/one_below.scene");
  above.tick(above.velocity);
  below.tick(below.velocity);
  ASSERT_EQ(above.rules.contacts.size(), 1u);
  EXPECT_EQ(above.rules.contacts[0].time, (Fraction{49001, 100000}));
  EXPECT_EQ(above.rules.contacts[0].point, Point(50000, 1));
  EXPECT_EQ(above.at(), Point(49001 + 1000 + (50999 - 2000), -1000));
  EXPECT_EQ(below.at(), Point(49001 + 1000 + (50999 - 2000), 1000)) << "the mirror image";
}

TEST(EndsTest, ATouchedFlankIsNothing) {
  HardScene scene("ends/touched.scene");
  scene.tick(scene.velocity);
  EXPECT_EQ(scene.at(), Point(100000, 0));
  scene.tick(-scene.velocity);
  EXPECT_EQ(scene.at(), Point(0, 0));
  EXPECT_TRUE(scene.rules.take().empty());
}

// A bump of one subunit is passed over (I3): at most 3 aside, and no speed is lost.
TEST(EndsTest, AClippedFlankPassesBeside) {
  HardScene scene("ends/clipped.scene");
  for (const int way : {1, -1}) {
    const Point before = scene.at();
    scene.tick({way * scene.velocity.x, 0});
    const Point moved = scene.at() - before;
    EXPECT_LE(std::abs(moved.x - way * 100000), 3);
    EXPECT_LE(std::abs(moved.y), 3);
    EXPECT_LE(scene.at().y, -1);
  }
  EXPECT_TRUE(scene.rules.take().empty());
}

}  // namespace
}  // namespace platon::hard_cases
