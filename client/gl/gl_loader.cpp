#include "client/gl/gl_loader.h"

#include <stdexcept>

#include <GL/glew.h>

namespace platon {

void loadOpenGl() {
  glewExperimental = GL_TRUE;
  const GLenum result = glewInit();
  // Without X, GLEW built for GLX finds no display, but it has loaded all functions by then.
  if (result != GLEW_OK && result != GLEW_ERROR_NO_GLX_DISPLAY) {
    throw std::runtime_error(std::string("OpenGL does not load: ") +
                             reinterpret_cast<const char*>(glewGetErrorString(result)));
  }
  if (GLEW_VERSION_3_3 == GL_FALSE) throw std::runtime_error("OpenGL 3.3 is needed; this machine has less");
  while (glGetError() != GL_NO_ERROR) {
    // GLEW's own questions may have left some.
  }
}

std::string takeGlErrors() {
  std::string words;
  for (GLenum error = glGetError(); error != GL_NO_ERROR; error = glGetError()) {
    words += (words.empty() ? "OpenGL error " : ", ") + std::to_string(error);
  }
  return words;
}

}  // namespace platon
