#include "tests/client/gl/shown_pictures.h"

#include <dlfcn.h>

#include <GL/glew.h>
#include <GLFW/glfw3.h>

namespace platon {

Image backBuffer() {
  int width = 0;
  int height = 0;
  glfwGetFramebufferSize(glfwGetCurrentContext(), &width, &height);
  Image image{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), {}};
  image.pixels.resize(std::size_t{3} * image.width * image.height);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  glReadBuffer(GL_BACK);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, image.pixels.data());
  flipRows(image);
  return image;
}

}  // namespace platon

// This definition takes precedence over that of the shared library.
extern "C" void glfwSwapBuffers(GLFWwindow* window) {
  using Swap = void (*)(GLFWwindow*);
  static const auto swap = reinterpret_cast<Swap>(dlsym(RTLD_NEXT, "glfwSwapBuffers"));
  ++platon::shownPictures;
  if (platon::onPicture) platon::onPicture();
  swap(window);
}
