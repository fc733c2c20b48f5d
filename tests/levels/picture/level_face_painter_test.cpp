#include "levels/picture/level_face_painter.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "tests/levels/picture/pixels.h"
#include "tests/support/test_levels.h"

namespace platon::level_face_painter_test {
namespace {

constexpr int kSize = 240;

// Face 0 of a hexahedron in the middle of a picture.
class LevelFacePainterTest : public testing::Test {
 protected:
  // `faceSize` level units are 200 pixels.
  Pixels painted(int faceSize, const std::string& segments) {
    const std::string size = std::to_string(faceSize);
    const std::string goal = std::to_string(faceSize / 4);
    const auto level =
        levelOf("HEXAHEDRON\n0 0 0 0\n0 " + goal + " " + goal + "\n" + size + "\n%\n" + segments + "%\n%\n%\n%\n%\n");
    const LevelDrawing drawing(*level);
    const double scale = 200.0 / faceSize;
    Canvas canvas(kSize, kSize, tints_.background());
    LevelFacePainter picture(canvas, drawing, 0, {{scale, 0}, {0, -scale}, {kSize / 2, kSize / 2}}, 1 / scale);
    picture.paintGround(tints_, 0.5);
    picture.paintSegments(tints_);
    picture.paintMarks(tints_);
    return Pixels(canvas);
  }

  const Tints tints_{SolidKind::kHexahedron};
};

TEST_F(LevelFacePainterTest, TheGroundFillsTheFace) {
  const Pixels pixels = painted(200, "");
  EXPECT_EQ(pixels.at(30, 30), pixelOf(tints_.face(0.5)));
  EXPECT_EQ(pixels.at(210, 210), pixelOf(tints_.face(0.5)));
  EXPECT_EQ(pixels.at(15, 120), pixelOf(tints_.background()));
}

TEST_F(LevelFacePainterTest, SegmentsLieWhereTheLevelHasThem) {
  const Pixels pixels = painted(200, "-80 -60 80 -60\n");
  EXPECT_EQ(pixels.at(60, 180), pixelOf(tints_.ink()));
  EXPECT_EQ(pixels.at(180, 178), pixelOf(tints_.ink()));
  EXPECT_EQ(pixels.at(60, 175), pixelOf(tints_.face(0.5)));
}

TEST_F(LevelFacePainterTest, StartAndGoalLieWhereTheLevelHasThem) {
  const Pixels pixels = painted(200, "");
  EXPECT_EQ(pixels.at(112, 120), pixelOf(Tints::start()));
  EXPECT_EQ(pixels.at(120, 116), pixelOf(tints_.background())) << "the mark of its up";
  EXPECT_EQ(pixels.at(120, 148), pixelOf(Tints::start())) << "the arrow of down";
  EXPECT_EQ(pixels.at(170, 70), pixelOf(Tints::goal()));
}

TEST_F(LevelFacePainterTest, OnALargeFaceEverythingStaysVisible) {
  const Pixels pixels = painted(65536, "-20000 -20000 20000 -20000\n");
  EXPECT_GT(pixels.count(Tints::start()), 40);
  EXPECT_GT(pixels.count(Tints::goal()), 10);
  EXPECT_NE(pixels.at(120, 181), pixelOf(tints_.face(0.5)));
}

TEST(PaintSegments, SegmentsAreAsWideAsStated) {
  const Tints tints(SolidKind::kHexahedron);
  Canvas canvas(60, 30, Colour(1));
  const std::vector<LevelDrawing::Line> lines = {{{10, 15}, {50, 15}, {}}};
  paintSegments(canvas, lines, tints, 6);
  const Pixels pixels(canvas);
  EXPECT_EQ(pixels.at(30, 12), pixelOf(tints.ink()));
  EXPECT_EQ(pixels.at(30, 17), pixelOf(tints.ink()));
  EXPECT_EQ(pixels.at(30, 11), 0xFFFFFFu);
  EXPECT_EQ(pixels.at(30, 18), 0xFFFFFFu);
}

TEST(PaintSegments, DrawsEverySegmentOfALongList) {
  const Tints tints(SolidKind::kHexahedron);
  Canvas canvas(1000, 8, Colour(1));
  std::vector<LevelDrawing::Line> lines;
  for (int x = 0; x < 1000; x += 2) lines.push_back({{x + 0.5, 0}, {x + 0.5, 8}, {}});
  paintSegments(canvas, lines, tints, 1);
  const Pixels pixels(canvas);
  for (int x = 0; x < 1000; ++x) ASSERT_EQ(pixels.at(x, 4), x % 2 == 0 ? pixelOf(tints.ink()) : 0xFFFFFFu) << x;
}

}  // namespace
}  // namespace platon::level_face_painter_test
