#include "client/gl/window.h"

#include <cstddef>
#include <cstdlib>
#include <stdexcept>

#include <GL/glew.h>
#include <gtest/gtest.h>

#include "client/gl/game_view.h"
#include "client/gl/gl_loader.h"

namespace platon {
namespace {

// What the window is about to show.
Image backBuffer(const Window& window) {
  Image image{window.pixelWidth(), window.pixelHeight(), {}};
  image.pixels.resize(std::size_t{3} * image.width * image.height);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  glReadBuffer(GL_BACK);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, static_cast<GLsizei>(image.width), static_cast<GLsizei>(image.height), GL_RGB, GL_UNSIGNED_BYTE,
               image.pixels.data());
  flipRows(image);
  return image;
}

// Starts within Xvfb; a machine without it has no display to open a window on.
TEST(Window, ShowsThePictureAlsoInFullScreen) {
  if (std::getenv("DISPLAY") == nullptr) GTEST_SKIP() << "no display";
  Window window("Platon", 640, 360);
  ASSERT_GT(window.pixelWidth(), 0U);
  GameView view(window.pixelWidth(), window.pixelHeight());
  for (const bool fullscreen : {false, true, false}) {
    window.setFullscreen(fullscreen);
    for (int i = 0; i < 20; ++i) window.poll();
    view.resize(window.pixelWidth(), window.pixelHeight());
    view.draw(nullptr, {.message = "Hello", .warning = false, .help = true}, Settings(), Menu(), 0);
    view.present();
    EXPECT_EQ(takeGlErrors(), "");
    EXPECT_EQ(backBuffer(window), view.read());
    window.show();
    EXPECT_EQ(window.held().left, false);
    EXPECT_FALSE(window.closing());
  }
}

TEST(Window, WithoutADisplayThereIsAReason) {
  if (std::getenv("DISPLAY") != nullptr || std::getenv("WAYLAND_DISPLAY") != nullptr) GTEST_SKIP() << "there is one";
  try {
    const Window window("Platon", 640, 360);
    FAIL() << "a window opened";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()).rfind("no window can be opened: ", 0), 0U) << error.what();
  }
}

}  // namespace
}  // namespace platon
