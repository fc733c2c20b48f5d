#include "client/gl/gl_context.h"

#include <optional>
#include <string>

#include <GL/glew.h>
#include <gtest/gtest.h>

#include "tests/support/environment_variable.h"

namespace platon::gl_context_test {
namespace {

TEST(Offscreen, GivesAContextOfOpenGl33WithoutADisplay) {
  const EnvironmentVariable noX("DISPLAY", std::nullopt);
  const EnvironmentVariable noWayland("WAYLAND_DISPLAY", std::nullopt);
  const Offscreen context;
  GLint major = 0;
  GLint minor = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  EXPECT_GE(10 * major + minor, 33);
  EXPECT_EQ(takeGlErrors(), "");
}

TEST(Offscreen, IsCurrentUntilItIsDestroyed) {
  {
    const Offscreen context;
    EXPECT_NE(glGetString(GL_VERSION), nullptr);
  }
  const Offscreen next;
  EXPECT_NE(glGetString(GL_VERSION), nullptr);
}

TEST(GlLoader, ErrorsAreReturnedOnce) {
  const Offscreen context;
  glEnable(GL_TEXTURE);
  EXPECT_EQ(takeGlErrors(), "OpenGL error " + std::to_string(GL_INVALID_ENUM));
  EXPECT_EQ(takeGlErrors(), "");
}

}  // namespace

}  // namespace platon::gl_context_test
