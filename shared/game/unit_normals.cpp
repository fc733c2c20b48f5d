#include "platon/game/unit_normals.h"

#include "platon/exact/integer.h"
#include "platon/game/player.h"
#include "shared/exact/square_root.h"
#include "shared/physics/turned_normal.h"

namespace platon {

Point UnitNormals::computed(Point normal, Angle turn) {
  Point vector = turnedNormal(normal, turn);
  while (maxNorm(vector) < (1 << 28)) vector = vector + vector;
  const std::int64_t length = squareRootFloor(squaredLength(vector));
  return {static_cast<std::int32_t>(divideRounded(std::int64_t{vector.x} * PlayerState::kUnit, length)),
          static_cast<std::int32_t>(divideRounded(std::int64_t{vector.y} * PlayerState::kUnit, length))};
}

}  // namespace platon
