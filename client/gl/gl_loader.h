#pragma once

#include <string>

namespace platon {

/// Finds the functions of the current OpenGL context. Throws std::runtime_error when it has less than OpenGL 3.3.
void loadOpenGl();

/// The errors that OpenGL has noted since the last call, as words; empty when there are none.
std::string takeGlErrors();

}  // namespace platon
