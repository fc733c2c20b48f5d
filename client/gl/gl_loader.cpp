#include "client/gl/gl_loader.h"

#include <stdexcept>

#include <GL/glew.h>

namespace platon {

void loadOpenGl() {
  glewExperimental = GL_TRUE;
  const GLenum result = glewInit();
  // Without X, GLEW built for GLX reports a missing display, but only after it has loaded all functions.
  if (result != GLEW_OK && result != GLEW_ERROR_NO_GLX_DISPLAY) {
    throw std::runtime_error(std::string("cannot load OpenGL: ") +
                             reinterpret_cast<const char*>(glewGetErrorString(result)));
  }
  if (GLEW_VERSION_3_3 == GL_FALSE) throw NoOpenGl();
  while (glGetError() != GL_NO_ERROR) {
    // Clears errors that glewInit has caused.
  }
}

std::string takeGlErrors() {
  std::string text;
  for (GLenum error = glGetError(); error != GL_NO_ERROR; error = glGetError()) {
    text += (text.empty() ? "OpenGL error " : ", ") + std::to_string(error);
  }
  return text;
}

std::string driverName() {
  const GLubyte* const name = glGetString(GL_RENDERER);
  return name == nullptr ? "" : reinterpret_cast<const char*>(name);
}

void finishDrawing() { glFinish(); }

}  // namespace platon
