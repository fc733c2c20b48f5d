#pragma once

#include <array>
#include <vector>

#include "levels/drawing/colour.h"
#include "platon/game/solid.h"

namespace platon {

/// The colours of a solid and of the sky round it. Each solid has those of its element in Plato's Timaeus: fire for the
/// tetrahedron, earth for the hexahedron, air for the octahedron, ether for the dodecahedron and water for the
/// icosahedron.
struct Scheme {
  static constexpr int kTones = 4;

  std::array<Colour, kTones> tones{};  ///< of faces, from dark to light, also for eyes that lack a kind of cones
  Colour wall{1};
  Colour skyTop{0};
  Colour skyBottom{0};
  Colour glow{0};  ///< in the sky behind the solid
  Colour mote{1};  ///< of the particles in the sky
};

const Scheme& schemeOf(SolidKind solid);

/// The tone of each face: no two neighbours have the same.
const std::vector<int>& tonesOfFaces(SolidKind solid);

}  // namespace platon
