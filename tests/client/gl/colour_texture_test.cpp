#include "client/gl/colour_texture.h"

#include <array>
#include <cstdint>

#include <gtest/gtest.h>

#include "client/gl/gl_loader.h"
#include "client/gl/offscreen.h"

namespace platon::colour_texture_test {
namespace {

TEST(ColourTexture, KeepsWhatIsDrawn) {
  const Offscreen context;
  const GlFramebuffer framebuffer;
  const GlTexture texture;
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
  attachColour(texture, 3, 2);
  ASSERT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
  glClearColor(1, 0.4F, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  std::array<std::uint8_t, 4> pixel{};
  glReadPixels(2, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
  EXPECT_EQ(pixel, (std::array<std::uint8_t, 4>{255, 102, 0, 255}));
  EXPECT_EQ(takeGlErrors(), "");
}

}  // namespace
}  // namespace platon::colour_texture_test
