#pragma once

#include <glm/vec3.hpp>

namespace platon {

/// sRGB, each component in [0, 1]. Colour is never the only distinction: shapes and numbers tell things apart, too.
using Colour = glm::vec3;

/// Converts from the Oklab colour space of Björn Ottosson: lightness [0, 1], chroma (0 grey … about 0.3) and hue in
/// degrees. Clamped to the gamut of sRGB.
Colour oklch(double lightness, double chroma, double hue);

}  // namespace platon
