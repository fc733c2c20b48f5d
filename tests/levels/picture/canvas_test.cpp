#include "levels/picture/canvas.h"

#include <cairo.h>
#include <gtest/gtest.h>

#include <numbers>
#include <string>
#include <vector>

#include "tests/levels/picture/pixels.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::canvas_test {
namespace {

constexpr std::uint32_t kWhite = 0xFFFFFF;
constexpr std::uint32_t kBlack = 0;

class CanvasTest : public testing::Test {
 protected:
  Canvas canvas_{40, 20, Colour(1)};
};

TEST_F(CanvasTest, BeginsWithItsBackground) {
  const Canvas canvas(3, 2, Colour(1, 0.5F, 0));
  EXPECT_EQ(canvas.pixels(), std::vector<std::uint32_t>(6, 0xFF8000));
}

TEST_F(CanvasTest, RowsBeginAtTheTop) {
  const glm::dvec2 corners[] = {{10, 0}, {20, 0}, {20, 5}, {10, 5}};
  canvas_.polygon(corners);
  canvas_.fill({Colour(0)});
  const Pixels pixels(canvas_);
  EXPECT_EQ(pixels.count(kBlack), 50);
  EXPECT_EQ(pixels.at(10, 0), kBlack);
  EXPECT_EQ(pixels.at(19, 4), kBlack);
  EXPECT_EQ(pixels.at(20, 4), kWhite);
  EXPECT_EQ(pixels.at(19, 5), kWhite);
}

TEST_F(CanvasTest, EdgesAreSmooth) {
  const glm::dvec2 corners[] = {{10, 0}, {20.5, 0}, {20.5, 20}, {10, 20}};
  canvas_.polygon(corners);
  canvas_.fill({Colour(0)});
  EXPECT_NEAR(Pixels(canvas_).at(20, 10) & 0xFF, 128, 1);
}

TEST_F(CanvasTest, DrawsThroughTheMap) {
  {
    const Canvas::Mapped mapped(canvas_, {{2, 0}, {0, -1}, {10, 20}});
    const glm::dvec2 corners[] = {{0, 0}, {5, 0}, {5, 4}, {0, 4}};
    canvas_.polygon(corners);
    canvas_.fill({Colour(0)});
  }
  const Pixels pixels(canvas_);
  EXPECT_EQ(pixels.count(kBlack), 40);
  EXPECT_EQ(pixels.at(10, 16), kBlack);
  EXPECT_EQ(pixels.at(19, 19), kBlack);
}

TEST_F(CanvasTest, AMapEndsWithItsObject) {
  { const Canvas::Mapped mapped(canvas_, {{5, 0}, {0, 5}, {100, 0}}); }
  canvas_.circle({20, 10}, 8);
  canvas_.fill({Colour(0)});
  EXPECT_NEAR(static_cast<double>(Pixels(canvas_).count(kBlack)), std::numbers::pi * 64, 45);
}

TEST_F(CanvasTest, OpacityMixesColours) {
  const glm::dvec2 corners[] = {{0, 0}, {40, 0}, {40, 20}, {0, 20}};
  canvas_.polygon(corners);
  canvas_.fill({Colour(0), 0.5});
  EXPECT_NEAR(Pixels(canvas_).at(7, 7) & 0xFF, 128, 1);
}

TEST_F(CanvasTest, LinesHaveRoundEnds) {
  canvas_.line({10, 10}, {30, 10});
  canvas_.stroke({Colour(0)}, 8);
  const Pixels pixels(canvas_);
  EXPECT_EQ(pixels.at(20, 6), kBlack);
  EXPECT_EQ(pixels.at(20, 5), kWhite);
  EXPECT_EQ(pixels.at(7, 10), kBlack) << "beyond the end";
  EXPECT_EQ(pixels.at(6, 6), kWhite) << "the corner of a square end";
}

TEST_F(CanvasTest, ALineWithoutLengthIsADot) {
  canvas_.line({20, 10}, {20, 10});
  canvas_.stroke({Colour(0)}, 10);
  EXPECT_GT(Pixels(canvas_).count(kBlack), 50);
}

TEST_F(CanvasTest, DashesHaveGapsOfTheirLength) {
  canvas_.line({2, 10}, {38, 10});
  canvas_.strokeDashed({Colour(0)}, 2, 5);
  canvas_.line({2, 18}, {38, 18});
  canvas_.stroke({Colour(0)}, 2);
  const Pixels pixels(canvas_);
  EXPECT_EQ(pixels.at(5, 9), kBlack);
  EXPECT_EQ(pixels.at(10, 9), kWhite);
  EXPECT_EQ(pixels.at(16, 9), kBlack);
  EXPECT_EQ(pixels.at(10, 17), kBlack) << "the next stroke has no dashes";
}

TEST_F(CanvasTest, TextStandsOnItsBaseline) {
  {
    const Canvas::Mapped mapped(canvas_, {{1, 0}, {0, -1}, {0, 0}});
    canvas_.text({4, -16}, 20, "HH");
    canvas_.fill({Colour(0)});
  }
  const Pixels pixels(canvas_);
  EXPECT_GT(pixels.count(kBlack), 40);
  for (int x = 0; x < 40; ++x) {
    EXPECT_EQ(pixels.at(x, 16), kWhite);
    EXPECT_EQ(pixels.at(x, 2), kWhite) << "the capitals are " << 20 * Typeface::kCapitalHeight << " high";
  }
}

TEST_F(CanvasTest, GivesAPng) {
  const TemporaryFolder folder;
  canvas_.circle({20, 10}, 8);
  canvas_.fill({Colour(0, 0.4F, 0.8F)});
  const std::string file = folder / "picture.png";
  writeText(file, canvas_.png());
  EXPECT_TRUE(readText(file).starts_with("\x89PNG\r\n"));
  cairo_surface_t* surface = cairo_image_surface_create_from_png(file.c_str());
  EXPECT_EQ(cairo_image_surface_get_width(surface), 40);
  EXPECT_EQ(cairo_image_surface_get_height(surface), 20);
  cairo_surface_destroy(surface);
}

TEST_F(CanvasTest, APictureThatCouldNotBeDrawnIsNone) {
  { const Canvas::Mapped flat(canvas_, {{0, 0}, {0, 0}, {0, 0}}); }
  try {
    (void)canvas_.png();
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "invalid matrix (not invertible)");
  }
}

}  // namespace
}  // namespace platon::canvas_test
