#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "platon/game/solid.h"
#include "platon/physics/convex.h"
#include "platon/physics/world.h"
#include "tests/fuzz/byte_source.h"

namespace platon::fuzz {

/// Static geometry and a shape, on one endless plane or on a solid.
struct FuzzScene {
  World stage;                     ///< without entities
  std::optional<SolidKind> solid;  ///< none: a plane, part 0
  std::int32_t faceSize = 0;       ///< level units; 0 on the plane
  std::vector<std::size_t> lines;  ///< by part, how many lines are neither posts nor warps
  Convex shape;
  std::int64_t scale = 0;  ///< about the size of shape and lines, subunits
  bool turns = false;      ///< every corner of the shape stays one however it is turned and rounded
};

/// Nothing when the bytes give no strictly convex shape.
std::optional<FuzzScene> makeFuzzScene(ByteSource& bytes);

}  // namespace platon::fuzz
