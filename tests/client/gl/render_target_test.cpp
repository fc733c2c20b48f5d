#include "client/gl/render_target.h"

#include <cstddef>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "client/gl/gl_loader.h"
#include "client/gl/offscreen.h"

namespace platon::render_target_test {
namespace {

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

}  // namespace
}  // namespace platon::render_target_test
