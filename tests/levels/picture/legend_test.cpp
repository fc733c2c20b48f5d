#include "levels/picture/legend.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/levels/picture/pixels.h"

namespace platon::legend_test {
namespace {

const std::set<ElementKind> kAll(kElementKinds.begin(), kElementKinds.end());

TEST(Legend, ShowsTheMarksInARow) {
  const Tints tints(SolidKind::kHexahedron);
  Canvas canvas(800, 60, tints.background());
  {
    const Canvas::Mapped mapped(canvas, {{1, 0}, {0, -1}, {0, 0}});
    paintLegend(canvas, {20, -30}, tints, {});
  }
  const Pixels pixels(canvas);
  EXPECT_GT(pixels.count(Tints::start()), 100);
  EXPECT_GT(pixels.count(Tints::goal()), 80);
  EXPECT_EQ(pixels.at(23, 30), pixelOf(Tints::start()));
  for (int y = 0; y < 60; ++y) {
    EXPECT_EQ(pixels.at(19, y), pixelOf(tints.background())) << "left of the start";
    EXPECT_EQ(pixels.at(799, y), pixelOf(tints.background())) << "the row fits";
  }
}

TEST(Legend, WithAllKindsItFitsOnThePage) {
  const Tints tints(SolidKind::kHexahedron);
  Canvas canvas(1600, 80, tints.background());
  {
    const Canvas::Mapped mapped(canvas, {{1, 0}, {0, -1}, {0, 0}});
    paintLegend(canvas, {64, -40}, tints, kAll);
  }
  const Pixels pixels(canvas);
  EXPECT_GT(pixels.count(Tints::hazard()), 10);
  EXPECT_GT(pixels.count(Tints::plate()), 10);
  for (int y = 0; y < 80; ++y) EXPECT_EQ(pixels.at(1536, y), pixelOf(tints.background()));
  for (int x = 0; x < 1600; ++x) EXPECT_EQ(pixels.at(x, 5), pixelOf(tints.background()));
}

}  // namespace
}  // namespace platon::legend_test
