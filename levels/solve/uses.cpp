#include "levels/solve/uses.h"

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

bool standsOn(const Game& game, std::uint32_t slot, const Element& plate) {
  constexpr std::int64_t reach = kPlayerRadius + kSubunitsPerUnit / 8;
  const EntityState& entity = game.world().entities()[slot];
  if (entity.part != plate.face || game.player(slot).ground == Point()) return false;
  return (game.openDoors() & plate.bit()) != 0 && squaredDistance(entity.position, plate.ends) <= reach * reach;
}

bool returnsTo(const Game& game, std::uint32_t slot, const Element& checkpoint) {
  const std::uint16_t last = game.player(slot).checkpoint;
  return last != 0 && game.level().elements[last - 1U] == checkpoint;
}

}  // namespace

bool uses(const Game& game, std::uint32_t slot, const Element& element) {
  switch (element.kind) {
    case ElementKind::kKey:
      return game.isTaken(element);
    case ElementKind::kPlate:
      return standsOn(game, slot, element);
    case ElementKind::kCheckpoint:
      return returnsTo(game, slot, element);
    case ElementKind::kOneway:
    case ElementKind::kUp:
    case ElementKind::kHazard:
    case ElementKind::kDoor:
    case ElementKind::kTimed:
      return false;
  }
  return false;
}

}  // namespace platon
