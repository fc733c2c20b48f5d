#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

namespace platon {

/// sRGB, each component in [0, 1]. Colour is never the only distinction: faces and players also have numbers.
using Colour = glm::vec3;

/// Converts from the Oklab colour space of Björn Ottosson: lightness [0, 1], chroma (0 grey … about 0.3) and hue in
/// degrees. Clamped to the gamut of sRGB.
Colour oklch(double lightness, double chroma, double hue);

/// Colour of a face: dark, so that segments stand out, and different from faces of nearby indices.
Colour faceColour(int face);

/// Colour of a player: bright, and different from players of nearby slots.
Colour playerColour(std::uint32_t slot);

}  // namespace platon
