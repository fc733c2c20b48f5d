#include "client/gl/gl_context.h"

#include <stdexcept>

#include <EGL/egl.h>
#include <EGL/eglext.h>
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

namespace {

void* openDisplay() {
  void* display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
  if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) != EGL_TRUE) {
    throw std::runtime_error("cannot draw off-screen: EGL has no surfaceless display; install Mesa's libEGL");
  }
  return display;
}

void* openContext(void* display) {
  const EGLint kConfig[] = {EGL_SURFACE_TYPE, EGL_DONT_CARE, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  const EGLint kContext[] = {
      EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  eglBindAPI(EGL_OPENGL_API);
  if (eglChooseConfig(display, kConfig, &config, 1, &count) != EGL_TRUE || count == 0) return nullptr;
  EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, kContext);
  if (context == EGL_NO_CONTEXT) return nullptr;
  return eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE ? context : nullptr;
}

}  // namespace

Offscreen::Offscreen() : display_(openDisplay()), context_(openContext(display_)) {
  if (context_ == nullptr) {
    eglTerminate(display_);
    throw NoOpenGl();
  }
  loadOpenGl();
}

Offscreen::~Offscreen() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
  eglTerminate(display_);
}

}  // namespace platon
