#include "client/gl/picture_fade.h"

#include <cstddef>

#include <gtest/gtest.h>

#include "client/gl/gl_loader.h"
#include "client/gl/offscreen.h"
#include "client/gl/render_target.h"

namespace platon::picture_fade_test {
namespace {

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
}  // namespace platon::picture_fade_test
