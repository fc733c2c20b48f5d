#include "client/gl/picture_scaler.h"

#include <gtest/gtest.h>

#include "client/gl/gl_loader.h"
#include "client/gl/offscreen.h"
#include "client/gl/render_target.h"

namespace platon::picture_scaler_test {
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

}  // namespace
}  // namespace platon::picture_scaler_test
