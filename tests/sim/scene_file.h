#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "platon/exact/point.h"
#include "platon/physics/convex.h"
#include "platon/physics/world.h"

namespace platon::sim {

/// A scene file: physics alone, on one map part without warps. Lines are words and whole numbers in subunits; `#`
/// begins a comment.
///   shape x y x y …        counter-clockwise, once
///   line x0 y0 x1 y1       any number
///   entity x y             one or more
///   velocity vx vy         given to every entity at the start of every tick (default 0 0)
struct Scene {
  World world;  ///< part 0, entities inserted
  Convex shape;
  Point velocity;
};

/// Throws InputError with every fault as `file:line:column: error: …`, a line each.
Scene loadScene(const std::string& file, std::string_view text);

}  // namespace platon::sim
