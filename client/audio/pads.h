#pragma once

#include "client/audio/pcm.h"
#include "platon/game/solid.h"

namespace platon {

/// Length of a pad, seconds.
inline constexpr int kPadSeconds = 24;

/// Makes the quiet music of a solid, a stereo loop without a seam. Its mood is that of the element to which Plato's
/// Timaeus assigns the solid: fire to the tetrahedron, earth to the cube, air to the octahedron, water to the
/// icosahedron; ether to the dodecahedron. Always the same samples.
Pcm makePad(SolidKind solid);

}  // namespace platon
