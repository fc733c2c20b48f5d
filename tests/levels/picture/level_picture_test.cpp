#include "levels/picture/level_picture.h"

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <cairo.h>
#include <gtest/gtest.h>

#include "levels/picture/element_painter.h"
#include "levels/picture/solid_view.h"
#include "tests/levels/picture/pixels.h"
#include "tests/support/files.h"
#include "tests/support/test_levels.h"

namespace platon::level_picture_test {
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

constexpr int kGoldenWidth = 400;

std::string stemOf(const std::string& path) { return std::filesystem::path(path).stem().string(); }

// The machine and the version of Cairo on which the golden pictures were drawn.
bool drawsAsTheGolden() {
#if defined(__x86_64__)
  return std::string_view(cairo_version_string()) == "1.16.0";
#else
  return false;
#endif
}

// The pixels of a PNG file; none if it cannot be read.
std::vector<std::uint32_t> pixelsOfFile(const std::string& file) {
  cairo_surface_t* read = cairo_image_surface_create_from_png(file.c_str());
  std::vector<std::uint32_t> pixels;
  const int stride = cairo_image_surface_get_stride(read);
  for (int y = 0; y < cairo_image_surface_get_height(read); ++y) {
    const unsigned char* row = cairo_image_surface_get_data(read) + std::ptrdiff_t{1} * y * stride;
    for (int x = 0; x < cairo_image_surface_get_width(read); ++x, row += sizeof(std::uint32_t)) {
      pixels.push_back(*reinterpret_cast<const std::uint32_t*>(row) & 0xFFFFFF);
    }
  }
  cairo_surface_destroy(read);
  return pixels;
}

// The mean difference of a byte.
double difference(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (const int shift : {0, 8, 16}) {
      sum += std::abs(static_cast<int>(a[i] >> shift & 0xFF) - static_cast<int>(b[i] >> shift & 0xFF));
    }
  }
  return sum / (3 * static_cast<double>(a.size()));
}

// One of each solid, and one with every element.
std::vector<std::string> drawnLevels() {
  std::vector<std::string> levels = solidLevels();
  levels.emplace_back("tests/levels/picture/elements.level");
  return levels;
}

class GoldenPictureTest : public testing::TestWithParam<std::string> {};

TEST_P(GoldenPictureTest, TheLevelLooksAsBefore) {
  const std::string golden = "tests/levels/picture/golden/" + stemOf(GetParam()) + ".png";
  const Canvas picture = drawLevel(*levelOf(readText(GetParam())), kGoldenWidth);
  const std::vector<std::uint32_t> expected = pixelsOfFile(golden);
  const std::vector<std::uint32_t> drawn = picture.pixels();
  ASSERT_EQ(drawn.size(), expected.size()) << golden;
  EXPECT_LT(difference(drawn, expected), drawsAsTheGolden() ? 1e-12 : 0.5)
      << "look at the new picture, and if it is right: platon-level preview " << GetParam() << " --width "
      << kGoldenWidth << " -o " << golden;
}

INSTANTIATE_TEST_SUITE_P(Levels, GoldenPictureTest, testing::ValuesIn(drawnLevels()),
                         [](const auto& one) { return stemOf(one.param); });

TEST(LevelPicture, HasTheStatedSize) {
  for (const int width : {kMinPictureWidth, 401, kPictureWidth}) {
    const Canvas picture = drawLevel(*levelOf(farGoalText()), width);
    EXPECT_EQ(picture.width(), width);
    EXPECT_EQ(picture.height(), width * 5 / 8);
  }
}

TEST(LevelPicture, HasAnEmptyMarginForEverySolid) {
  for (int kind = 0; kind < kSolidKinds; ++kind) {
    const auto solid = static_cast<SolidKind>(kind);
    std::string text = "# title: " + std::string(100, 'W') + "\n# author: " + std::string(100, 'W') + "\n";
    text += std::string(nameOf(solid)) + "\n0 0 0 33\n1 0 0\n200\n";
    for (int face = 0; face < PlatonicSolid::of(solid).faces(); ++face) text += "%\n";
    const Canvas picture = drawLevel(*levelOf(text), 800);
    const Pixels pixels(picture);
    const std::uint32_t background = pixelOf(Tints(solid).background());
    for (int i = 0; i < 800; ++i) {
      const int y = i * 5 / 8;
      EXPECT_EQ(pixels.at(i, 12), background);
      EXPECT_EQ(pixels.at(i, 487), background);
      EXPECT_EQ(pixels.at(20, y), background);
      EXPECT_EQ(pixels.at(779, y), background);
    }
  }
}

// The pixels of the title and of the line below it.
std::vector<std::uint32_t> titleOf(const std::string& head) {
  const auto level = levelOf(head + "HEXAHEDRON\n0 0 0 0\n1 0 0\n480\n%\n%\n%\n%\n%\n%\n");
  std::vector<std::uint32_t> pixels = drawLevel(*level, 800).pixels();
  pixels.resize(800 * 70);
  return pixels;
}

TEST(LevelPicture, TheSolidIsNamedWhereThereIsNoTitle) {
  EXPECT_NE(titleOf(""), titleOf("# title: Hexahedron\n")) << "the title is followed by the solid";
  EXPECT_NE(titleOf("# author: A\n"), titleOf(""));
  EXPECT_NE(titleOf("# author: A\n"), titleOf("# title: Hexahedron\n# author: A\n"));
}

TEST(LevelPicture, AFaceHasTheSameTintInTheNetAndInItsView) {
  const auto level = levelOf(farGoalText());
  const Pixels pixels(drawLevel(*level, 800));
  const SolidFrame solid(level->solid, level->faceSize);
  const SolidView front = frontView(solid, static_cast<int>(level->startFace), level->startAngle);
  for (int face = 0; face < solid.faces(); ++face) {
    const SolidView view = front.shows(solid, face) ? front : oppositeOf(front);
    const std::uint32_t tint = pixelOf(Tints(level->solid).face(view.brightness(solid, face)));
    std::ptrdiff_t left = 0;
    std::ptrdiff_t right = 0;
    for (int y = 0; y < 500; ++y) {
      for (int x = 0; x < 800; ++x) (x < 270 ? left : right) += pixels.at(x, y) == tint ? 1 : 0;
    }
    EXPECT_GT(left, 2000) << "face " << face;
    EXPECT_GT(right, 8000) << "face " << face;
  }
}

}  // namespace

}  // namespace platon::level_picture_test
