#include "levels/picture/mark_painter.h"

#include <gtest/gtest.h>

#include "tests/levels/picture/pixels.h"

namespace platon::mark_painter_test {
namespace {

class MarkPainterTest : public testing::Test {
 protected:
  const Tints tints_{SolidKind::kHexahedron};
  Canvas canvas_{60, 60, Colour(1)};
};

TEST_F(MarkPainterTest, TheMarkOfABallPointsToItsUp) {
  paintBall(canvas_, {30, 30}, {1, 0}, 20, tints_);
  const Pixels pixels(canvas_);
  EXPECT_EQ(pixels.at(38, 30), pixelOf(tints_.background()));
  EXPECT_EQ(pixels.at(22, 30), pixelOf(Tints::start()));
  EXPECT_EQ(pixels.at(30, 48), pixelOf(Tints::start()));
  EXPECT_EQ(pixels.at(30, 55), 0xFFFFFFu);
}

TEST_F(MarkPainterTest, AGoalIsARingRoundADot) {
  paintGoal(canvas_, {30, 30}, 20, tints_);
  const Pixels pixels(canvas_);
  EXPECT_EQ(pixels.at(30, 30), pixelOf(Tints::goal()));
  EXPECT_EQ(pixels.at(47, 30), pixelOf(Tints::goal()));
  EXPECT_NE(pixels.at(40, 30), pixelOf(Tints::goal()));
  EXPECT_EQ(pixels.at(55, 30), 0xFFFFFFu);
}

TEST_F(MarkPainterTest, AnArrowHasItsBarbsAtTheHead) {
  paintArrow(canvas_, {30, 10}, {30, 50}, {Colour(0)}, 4);
  const Pixels pixels(canvas_);
  EXPECT_EQ(pixels.at(30, 12), 0u);
  EXPECT_EQ(pixels.at(30, 49), 0u);
  EXPECT_EQ(pixels.at(22, 37), 0u);
  EXPECT_EQ(pixels.at(38, 37), 0u);
  EXPECT_EQ(pixels.at(22, 20), 0xFFFFFFu);
}

}  // namespace
}  // namespace platon::mark_painter_test
