#pragma once

#include <string>

namespace platon {

/// Loads the functions of the current OpenGL context. Throws std::runtime_error below OpenGL 3.3.
void loadOpenGl();

/// Returns and clears the recorded OpenGL errors as text; empty if there are none.
std::string takeGlErrors();

/// What the driver of the current context calls itself: GL_RENDERER.
std::string driverName();

/// Waits until everything is drawn.
void finishDrawing();

}  // namespace platon
