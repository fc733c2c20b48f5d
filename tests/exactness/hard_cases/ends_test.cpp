// Ends of segments against vertices of shapes.
#include <gtest/gtest.h>

#include <cstdlib>

#include "platon/exact/fraction.h"
#include "tests/exactness/hard_cases/checked_world.h"
#include "tests/exactness/hard_cases/sweep_cases.h"

namespace platon::hard_cases::ends_test {
namespace {

// A square that stands on its vertex moves to the right. Segments of many directions end at its leading vertex, one
// subunit beside it, and at its sides.
TEST(EndsTest, SweepsAgainstEndsAreExact) {
  EXPECT_EQ(expectAnswers("ends/small"), 28u);
  EXPECT_EQ(expectAnswers("ends/far"), 28u) << "over a million times as large, still off by one subunit";
}

// A vertex that hits the end exactly enters both of its edges at once: the edge with the smaller index is the contact.
// Here that edge leads up to the left, so the entity slides off below the segment, 1 000 subunits down and to the
// right. The slide has half the speed, so these 1 000 subunits use 2 000 of the displacement; the remaining
// displacement is straight.
TEST(EndsTest, AVertexAtAnEndSlidesAlongItsFirstEdge) {
  HardScene scene("ends/straight.scene");
  scene.tick(scene.velocity);
  ASSERT_EQ(scene.rules.contacts.size(), 1u);
  const Contact contact = scene.rules.contacts[0];
  EXPECT_EQ(contact.point, Point(50000, 0));
  EXPECT_EQ(contact.time, (Fraction{49, 100}));
  EXPECT_EQ(contact.normal, Point(-1000, -1000));
  EXPECT_EQ(scene.at(), Point(49000 + 1000 + (51000 - 2000), -1000));
  const Point before = scene.at();
  scene.tick(scene.velocity);
  EXPECT_EQ(scene.at(), before + scene.velocity) << "free beside the segment";
  for (int back = 0; back < 2; ++back) scene.tick(-scene.velocity);
  EXPECT_EQ(scene.at(), before - scene.velocity);
  EXPECT_EQ(scene.rules.take().size(), 1u) << "there are further contacts";
}

// After four ticks the tip is at the end. It slides off along the long edge by (30 040, 11 900), and one subunit more.
// That is 0.6 of (50 066, 19 833), the slide of a whole tick. The remaining 0.4 of the displacement, and all further
// motion, is straight beside the segment.
TEST(EndsTest, TheTipOfANeedleSlidesOffTheEnd) {
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

TEST(EndsTest, AVertexAtAFarEndSlidesAlongItsFirstEdge) {
  HardScene scene("ends/straight_far.scene");
  scene.tick(scene.velocity);
  EXPECT_EQ(scene.rules.contacts.at(0).point, Point(200000000, 0));
  EXPECT_EQ(scene.rules.contacts.at(0).time, (Fraction{249000000, 268435455}));
  constexpr std::int32_t left = 268435455 - 249000000;
  constexpr std::int32_t edge = 1000000;
  EXPECT_EQ(scene.at(), Point(199000000 + edge + (left - 2 * edge), -edge)) << "a thousand times as large";
}

// An end one subunit beside the vertex: the entity slides off along the edge, of which 999 subunits remain. This uses
// 1 998 of the remaining 50 999.
TEST(EndsTest, AVertexOneSubunitBesideTheEndSlidesOff) {
  HardScene above("ends/one_above.scene");
  HardScene below("ends/one_below.scene");
  above.tick(above.velocity);
  below.tick(below.velocity);
  ASSERT_EQ(above.rules.contacts.size(), 1u);
  EXPECT_EQ(above.rules.contacts[0].time, (Fraction{49001, 100000}));
  EXPECT_EQ(above.rules.contacts[0].point, Point(50000, 1));
  EXPECT_EQ(above.at(), Point(49001 + 999 + (50999 - 1998), -999));
  EXPECT_EQ(below.at(), Point(49001 + 999 + (50999 - 1998), 999)) << "the mirror image";
}

TEST(EndsTest, AnEndThatTouchesASideIsNotAContact) {
  HardScene scene("ends/touched.scene");
  scene.tick(scene.velocity);
  EXPECT_EQ(scene.at(), Point(100000, 0));
  scene.tick(-scene.velocity);
  EXPECT_EQ(scene.at(), Point(0, 0));
  EXPECT_TRUE(scene.rules.take().empty());
}

// The entity slides over a bump of one subunit (I3): at most 3 subunits to the side, without loss of speed.
TEST(EndsTest, AnEndOneSubunitInsideIsPassed) {
  HardScene scene("ends/clipped.scene");
  for (const int direction : {1, -1}) {
    const Point before = scene.at();
    scene.tick({direction * scene.velocity.x, 0});
    const Point moved = scene.at() - before;
    EXPECT_LE(std::abs(moved.x - direction * 100000), 3);
    EXPECT_LE(std::abs(moved.y), 3);
    EXPECT_LE(scene.at().y, -1);
    EXPECT_EQ(scene.rules.contacts.size(), direction == 1 ? 1u : 0u);
  }
}

}  // namespace
}  // namespace platon::hard_cases::ends_test
