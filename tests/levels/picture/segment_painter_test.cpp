#include "levels/picture/face_painter.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/levels/picture/pixels.h"

namespace platon::segment_painter_test {
namespace {

TEST(SegmentPainter, SegmentsAreAsWideAsStated) {
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

TEST(SegmentPainter, DrawsEverySegmentOfALongList) {
  const Tints tints(SolidKind::kHexahedron);
  Canvas canvas(1000, 8, Colour(1));
  std::vector<LevelDrawing::Line> lines;
  for (int x = 0; x < 1000; x += 2) lines.push_back({{x + 0.5, 0}, {x + 0.5, 8}, {}});
  paintSegments(canvas, lines, tints, 1);
  const Pixels pixels(canvas);
  for (int x = 0; x < 1000; ++x) ASSERT_EQ(pixels.at(x, 4), x % 2 == 0 ? pixelOf(tints.ink()) : 0xFFFFFFu) << x;
}

}  // namespace
}  // namespace platon::segment_painter_test
