#include "levels/picture/element_painter.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/levels/picture/pixels.h"

namespace platon::element_painter_test {
namespace {

class TintsTest : public testing::TestWithParam<int> {
 protected:
  Tints tints() const { return Tints(static_cast<SolidKind>(GetParam())); }
};

float luma(Colour colour) { return glm::dot(colour, Colour(0.2126F, 0.7152F, 0.0722F)); }

TEST_P(TintsTest, InkAndMarksStandOutFromFacesAndBackground) {
  for (double brightness = 0; brightness <= 1; brightness += 0.125) {
    EXPECT_GT(luma(tints().face(brightness)) - luma(tints().ink()), 0.3F) << brightness;
    EXPECT_GT(luma(tints().face(brightness)) - luma(Tints::start()), 0.08F) << brightness;
    EXPECT_GT(luma(tints().face(brightness)) - luma(Tints::goal()), 0.1F) << brightness;
  }
  EXPECT_GT(luma(tints().background()) - luma(tints().ink()), 0.6F);
}

TEST_P(TintsTest, MoreLightMakesAFaceBrighter) {
  for (int step = 0; step < 8; ++step) {
    EXPECT_LT(luma(tints().face(step / 8.0)), luma(tints().face((step + 1) / 8.0))) << step;
  }
  EXPECT_LT(luma(tints().face(1)), luma(tints().background()));
}

TEST_P(TintsTest, SolidsHaveDifferentTints) {
  for (int other = 0; other < GetParam(); ++other) {
    const Tints others(static_cast<SolidKind>(other));
    EXPECT_GT(glm::distance(tints().face(0.5), others.face(0.5)), 0.08F) << other;
  }
}

INSTANTIATE_TEST_SUITE_P(AllSolids, TintsTest, testing::Range(0, kSolidKinds));

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

class ElementPainterTest : public testing::Test {
 protected:
  // The segment from (20, 40) to (180, 40), in a picture of 200 × 80 whose +y points up.
  Canvas painted(const ElementStyle& style, bool reversed = false) const {
    Canvas canvas(200, 80, tints_.face(0.5));
    const Canvas::Mapped mapped(canvas, {{1, 0}, {0, -1}, {0, 80}});
    const glm::dvec2 a(20, 40);
    const glm::dvec2 b(180, 40);
    ElementPainter(canvas, tints_, 4).paint(reversed ? b : a, reversed ? a : b, style);
    return canvas;
  }

  // How many pixels of a half of the picture are drawn.
  std::ptrdiff_t drawn(const Canvas& canvas, bool upper) const {
    const Pixels pixels(canvas);
    std::ptrdiff_t count = 0;
    for (int y = upper ? 0 : 40; y < (upper ? 40 : 80); ++y) {
      for (int x = 0; x < 200; ++x) count += pixels.at(x, y) != pixelOf(tints_.face(0.5)) ? 1 : 0;
    }
    return count;
  }

  const Tints tints_{SolidKind::kOctahedron};
};

// Brightness alone, as on a grey print.
std::vector<int> greyOf(const Canvas& canvas) {
  std::vector<int> grey;
  for (const std::uint32_t pixel : canvas.pixels()) {
    grey.push_back(static_cast<int>(((pixel >> 16 & 255) * 2 + (pixel >> 8 & 255) * 5 + (pixel & 255)) / 8));
  }
  return grey;
}

TEST_F(ElementPainterTest, KindsDifferWithoutColour) {
  for (const ElementKind a : kElementKinds) {
    for (const ElementKind b : kElementKinds) {
      if (a >= b) continue;
      const std::vector<int> greyOfA = greyOf(painted({a, 1, {0, 1}}));
      const std::vector<int> greyOfB = greyOf(painted({b, 1, {0, 1}}));
      int different = 0;
      for (std::size_t i = 0; i < greyOfA.size(); ++i) different += std::abs(greyOfA[i] - greyOfB[i]) > 64 ? 1 : 0;
      EXPECT_GT(different, 150) << wordOf(a) << " and " << wordOf(b) << " look alike";
    }
  }
}

TEST_F(ElementPainterTest, AOneWaySegmentHasItsChevronsOnTheRight) {
  const ElementStyle style{ElementKind::kOneway, 0, {0, 1}};
  EXPECT_GT(drawn(painted(style), false), drawn(painted(style), true) + 300);
  EXPECT_GT(drawn(painted(style, true), true), drawn(painted(style, true), false) + 300) << "from b to a";
}

TEST_F(ElementPainterTest, TheArrowsOfUpPointToTheEdge) {
  const Canvas upwards = painted({ElementKind::kUp, 0, {0, 1}});
  const Canvas downwards = painted({ElementKind::kUp, 0, {0, -1}});
  EXPECT_GT(drawn(upwards, true), drawn(upwards, false) + 50);
  EXPECT_GT(drawn(downwards, false), drawn(downwards, true) + 50);
}

TEST_F(ElementPainterTest, APlateIsRaisedOnItsLeft) {
  const ElementStyle style{ElementKind::kPlate, 1, {0, 1}};
  EXPECT_GT(drawn(painted(style), true), drawn(painted(style), false) + 300);
  EXPECT_GT(drawn(painted(style, true), false), drawn(painted(style, true), true) + 300) << "from b to a";
}

TEST_F(ElementPainterTest, NumbersAreDrawn) {
  for (const ElementKind kind : kElementKinds) {
    if (traitsOf(kind).number != ElementNumber::kDoor) continue;  // arrows show the edge, and a clock the times
    EXPECT_NE(painted({kind, 1, {0, 1}}).pixels(), painted({kind, 2, {0, 1}}).pixels()) << wordOf(kind);
  }
}

TEST_F(ElementPainterTest, ASegmentWithoutLengthIsDrawn) {
  for (const ElementKind kind : kElementKinds) {
    Canvas canvas(80, 80, tints_.face(0.5));
    ElementPainter(canvas, tints_, 4).paint({40, 40}, {40, 40}, {kind, 1, {0, 1}});
    EXPECT_LT(Pixels(canvas).count(tints_.face(0.5)), 6400 - 8) << wordOf(kind);
  }
}

}  // namespace

}  // namespace platon::element_painter_test
