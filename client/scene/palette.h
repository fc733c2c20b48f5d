#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

namespace platon {

/// sRGB, each part in [0, 1]. Colour is never the only sign: every face and every player has a number, too.
using Colour = glm::vec3;

/// A colour by lightness [0, 1], chroma (0 grey … about 0.3) and hue in degrees, by the Oklab space of Björn Ottosson;
/// cut to what sRGB can show.
Colour oklch(double lightness, double chroma, double hue);

/// Of a face by its index: dark enough for lines to stand out, and unlike the faces next in number.
Colour faceColour(int face);

/// Of a player by its slot: bright, and unlike the slots next in number.
Colour playerColour(std::uint32_t slot);

}  // namespace platon
