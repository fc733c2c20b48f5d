#include "client/gl/gl_objects.h"

#include <array>
#include <cstdint>

#include <gtest/gtest.h>

#include "client/gl/game_view.h"
#include "client/gl/gl_context.h"
#include "tests/client/gl/test_stage.h"

namespace platon::gl_objects_test {
namespace {

class DrawCallsTest : public testing::Test {
 protected:
  // The draw calls of a picture.
  std::uint64_t callsOf(const Scene* scene) {
    const std::uint64_t before = DrawCalls::count();
    view_.draw(scene, {}, Settings(), Overlay(), 0.1);
    EXPECT_EQ(takeGlErrors(), "");
    return DrawCalls::count() - before;
  }

  Offscreen context_;
  GameView view_{320, 180};
};

TEST_F(DrawCallsTest, APlayerIsABallItsNumberAndItsShadow) {
  const auto stage = cube();
  const Scene none = sceneOf(stage);
  Scene one = sceneOf(stage, {playerAt(*stage, 0, 0, {30, 20})});
  callsOf(&none);
  EXPECT_EQ(callsOf(&one) - callsOf(&none), 3U) << "the display shows no names";
}

TEST_F(DrawCallsTest, EqualPicturesHaveEqualCounts) {
  const Scene scene = sceneOf(cube());
  callsOf(&scene);
  const std::uint64_t calls = callsOf(&scene);
  EXPECT_GT(calls, 0U);
  EXPECT_EQ(callsOf(&scene), calls);
}

TEST_F(DrawCallsTest, WithheldCallsAreCountedAndDrawNothing) {
  const Scene scene = sceneOf(cube());
  callsOf(&scene);
  const std::uint64_t calls = callsOf(&scene);
  const Image image = view_.read();
  Scene other = sceneOf(scene.stage, {playerAt(*scene.stage, 0, 0, {30, 20})});
  DrawCalls::withhold(true);
  EXPECT_GT(callsOf(&other), calls);
  DrawCalls::withhold(false);
  EXPECT_EQ(view_.read(), image);
  callsOf(&other);
  EXPECT_NE(view_.read(), image);
}

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

}  // namespace platon::gl_objects_test
