#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "platon/game/solid.h"
#include "platon/physics/convex.h"
#include "platon/physics/world.h"
#include "tests/fuzz/byte_source.h"

namespace platon::fuzz {

/// Static geometry, on an infinite plane or on a solid, and a shape.
struct FuzzScene {
  World stage;                     ///< without entities
  std::optional<SolidKind> solid;  ///< nothing: a plane, part 0
  std::int32_t faceSize = 0;       ///< level units; 0 on the plane
  std::vector<std::size_t> lines;  ///< number of segments by part, without posts and warps
  Convex shape;
  std::int64_t scale = 0;  ///< about the size of the shape and the segments, subunits
  bool turns = false;      ///< the shape stays strictly convex at every angle
};

/// Makes a scene from bytes. Returns nothing if they give no strictly convex shape.
std::optional<FuzzScene> makeFuzzScene(ByteSource& bytes);

}  // namespace platon::fuzz
