#pragma once

#include "client/audio/wave.h"
#include "platon/game/solid.h"

namespace platon {

/// Length of the music of a solid, seconds.
inline constexpr int kMusicSeconds = 24;

/// Makes the quiet music of a solid, a stereo loop without a seam. Its mood is that of the element to which Plato's
/// Timaeus assigns the solid: fire to the tetrahedron, earth to the cube, air to the octahedron, water to the
/// icosahedron; ether to the dodecahedron. Always the same samples.
Pcm makeMusic(SolidKind solid);

}  // namespace platon
