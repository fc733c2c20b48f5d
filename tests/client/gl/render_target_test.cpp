#include "client/gl/render_target.h"

#include <cstddef>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "client/gl/gl_context.h"

namespace platon::render_target_test {
namespace {

// Left half black, right half white; then scaled to the size of the picture.
Image halves(std::uint32_t width, double scale) {
  const RenderTarget target(width, 4, 1, scale);
  target.bindSampled();
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glEnable(GL_SCISSOR_TEST);
  glScissor(static_cast<GLint>(target.sampledWidth() / 2), 0, static_cast<GLsizei>(width), 4);
  glClearColor(1, 1, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_SCISSOR_TEST);
  target.resolve();
  EXPECT_EQ(takeGlErrors(), "");
  return target.read();
}

TEST(PictureScaler, InterpolatesLinearly) {
  const Offscreen context;
  const Image image = halves(8, 0.5);
  const std::vector<int> expected{0, 0, 0, 64, 191, 255, 255, 255};
  for (std::size_t x = 0; x < expected.size(); ++x) EXPECT_NEAR(image.pixels[3 * x], expected[x], 1) << x;
}

TEST(PictureScaler, FillsThePicture) {
  const Offscreen context;
  for (const double scale : {0.5, 0.75, 0.85}) {
    const Image image = halves(40, scale);
    for (std::size_t y = 0; y < image.height; ++y) {
      EXPECT_EQ(image.pixels[3 * 40 * y], 0) << scale;
      EXPECT_EQ(image.pixels[3 * (40 * y + 39)], 255) << scale;
    }
  }
}

void clear(float red, float green, float blue) {
  glClearColor(red, green, blue, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

class RenderTargetTest : public testing::Test {
 protected:
  Offscreen context_;
};

TEST_F(RenderTargetTest, ReadReturnsWhatWasDrawnAndResolved) {
  const RenderTarget target(5, 3, 4);
  EXPECT_EQ(target.width(), 5U);
  EXPECT_EQ(target.height(), 3U);
  target.bindSampled();
  clear(1, 0, 0.2F);
  target.resolve();
  const Image image = target.read();
  ASSERT_EQ(image.pixels.size(), std::size_t{3} * 5 * 3);
  for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
    EXPECT_EQ(image.pixels[i], 255);
    EXPECT_EQ(image.pixels[i + 1], 0);
    EXPECT_EQ(image.pixels[i + 2], 51);
  }
  EXPECT_EQ(takeGlErrors(), "");
}

TEST_F(RenderTargetTest, RowsAreReadFromTheTop) {
  const RenderTarget target(1, 2, 1);
  target.bindSampled();
  clear(0, 0, 0);
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, 1, 1, 1);  // OpenGL counts rows from the bottom
  clear(1, 1, 1);
  glDisable(GL_SCISSOR_TEST);
  target.resolve();
  EXPECT_EQ(target.read().pixels, (std::vector<std::uint8_t>{255, 255, 255, 0, 0, 0}));
}

TEST_F(RenderTargetTest, AfterResolveDrawingGoesToThePlainPicture) {
  const RenderTarget target(1, 1, 4);
  target.bindSampled();
  clear(1, 0, 0);
  target.resolve();
  clear(0, 1, 0);
  EXPECT_EQ(target.read().pixels, (std::vector<std::uint8_t>{0, 255, 0}));
  target.resolve();
  EXPECT_EQ(target.read().pixels, (std::vector<std::uint8_t>{255, 0, 0}));
}

TEST_F(RenderTargetTest, MoreSamplesThanTheDriverHasAreLimited) {
  const RenderTarget target(8, 8, 1 << 20);
  EXPECT_EQ(takeGlErrors(), "");
}

TEST_F(RenderTargetTest, AnUnsupportedSizeIsAnError) {
  EXPECT_THROW(RenderTarget(1U << 24, 1U << 24, 1), std::runtime_error);
  takeGlErrors();
}

void fill(const RenderTarget& target, float grey) {
  target.bindSampled();
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glClearColor(grey, grey, grey, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  target.resolve();
}

TEST(PictureFade, IsBetweenTheKeptPictureAndTheNewOne) {
  const Offscreen context;
  PictureFade fade;
  for (const int samples : {1, 4}) {
    const RenderTarget target(6, 4, samples);
    fill(target, 1);
    fade.keep(target);
    for (const double opacity : {0.0, 0.25, 1.0}) {
      fill(target, 0);
      fade.draw(opacity);
      const Image image = target.read();
      for (std::size_t i = 0; i < image.pixels.size(); ++i) ASSERT_NEAR(image.pixels[i], 255 * opacity, 1) << i;
    }
  }
  EXPECT_EQ(takeGlErrors(), "");
}

}  // namespace

}  // namespace platon::render_target_test
