#include "tests/client/gl/shown_pictures.h"

#include <dlfcn.h>

#include <GLFW/glfw3.h>

// This definition takes precedence over that of the shared library.
extern "C" void glfwSwapBuffers(GLFWwindow* window) {
  using Swap = void (*)(GLFWwindow*);
  static const auto swap = reinterpret_cast<Swap>(dlsym(RTLD_NEXT, "glfwSwapBuffers"));
  ++platon::shownPictures;
  if (platon::onPicture) platon::onPicture();
  swap(window);
}
