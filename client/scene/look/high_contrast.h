#pragma once

#include "client/scene/look/scheme.h"

namespace platon {

/// The scheme with high contrast: a black sky, white walls and almost black faces, which still differ in lightness.
Scheme highContrast(const Scheme& scheme);

/// The colour of a face with high contrast, from that without.
Colour highContrastFace(Colour face);

}  // namespace platon
