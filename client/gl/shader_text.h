#pragma once

#include <string>
#include <string_view>

namespace platon {

/// The text of a file in client/gl/shaders, "face.vert", with the parts that it includes: GLSL 3.30 without the
/// #version line. The build compiles the files into the program. Throws std::logic_error if there is no such file.
/// Colours are blended as sRGB values, without conversion to linear light.
const std::string& shaderText(std::string_view file);

}  // namespace platon
