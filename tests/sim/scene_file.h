#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "platon/exact/point.h"
#include "platon/physics/convex.h"
#include "platon/physics/world.h"

namespace platon::sim {

/// A scene: entities of one shape on one map part without warps, without game rules. A line of a scene file is a word
/// with integers in subunits; `#` starts a comment:
///   shape x y x y …        counter-clockwise, once
///   line x0 y0 x1 y1       any number
///   entity x y             one or more
///   velocity vx vy         given to every entity at the start of every tick (default 0 0)
struct Scene {
  World world;  ///< part 0, entities inserted
  Convex shape;
  Point velocity;
};

/// Reads a scene. Throws InputError with one line `file:line:column: error: …` per error.
Scene loadScene(const std::string& file, std::string_view text);

}  // namespace platon::sim
