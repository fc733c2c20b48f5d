#include "levels/solve/plates.h"

#include <algorithm>

#include "platon/exact/integer.h"

namespace platon {
namespace {

// Squared distance of the point from the segment, rounded.
std::int64_t squaredDistance(Point point, const Segment& segment) {
  const Point along = segment.b - segment.a;
  const Point fromA = point - segment.a;
  if (dot(fromA, along) <= 0) return squaredLength(fromA);
  if (dot(point - segment.b, along) >= 0) return squaredLength(point - segment.b);
  const int128 beside = cross(along, fromA);
  return static_cast<std::int64_t>(beside * beside / squaredLength(along));
}

}  // namespace

bool standsOn(const Game& game, std::uint32_t slot, const Element& plate) {
  constexpr std::int64_t reach = kPlayerRadius + kSubunitsPerUnit / 8;
  const EntityState& entity = game.world().entities()[slot];
  if (entity.part != plate.face || game.player(slot).ground == Point()) return false;
  return (game.openDoors() & plate.bit()) != 0 && squaredDistance(entity.position, plate.ends) <= reach * reach;
}

}  // namespace platon
