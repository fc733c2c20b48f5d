#include "shared/game/element_rules.h"

#include <algorithm>

#include "platon/exact/integer.h"
#include "platon/game/player.h"
#include "platon/game/solid.h"

namespace platon {
namespace {

// Whether a player with its centre there is on the left of the segment: wholly on the left of its line, or above one of
// its ends, at most 45° to the side. The latter holds a player that rolls over the top of two slopes whose ends do not
// meet exactly. Bounds: coordinates < 2^27, so that products are < 2^56.
bool isLeftOf(const Segment& segment, Point centre) {
  constexpr std::int64_t distance = kPlayerApothem - kOnewaySlack;
  const Point along = segment.b - segment.a;
  const std::int64_t length = squaredLength(along);
  const std::int64_t passed = dot(along, centre - segment.a);
  const int128 beside = cross(along, centre - segment.a);
  const int128 beyond = std::max({std::int64_t{0}, -passed, passed - length});
  const int128 limit = int128{distance * distance} * length;
  return beside >= 0 && (beside * beside >= limit || (beyond <= beside && beside * beside + beyond * beyond >= limit));
}

}  // namespace

ElementRules::ElementRules(const Level& level, OpenElements open)
    : elements_(level.elements), edgesPerFace_(PlatonicSolid::of(level.solid).edgesPerFace()), open_(open) {}

bool ElementRules::mayPierce(std::uint32_t part, std::uint32_t index) const {
  const Element* const element = findElement(elements_, part, index);
  return element != nullptr && !blocksAlways(element->kind);
}

bool ElementRules::pierce(const Entity& entity, const SegmentRef& segment) const {
  const Element* const element = elementOf(segment);
  if (element == nullptr) return false;
  switch (element->kind) {
    case ElementKind::kOneway:
      return !isLeftOf(segment.ends, segment.position);
    case ElementKind::kUp:
      return !pointsTo(upOnFaceOf(segment, entity), *element, edgesPerFace_);
    case ElementKind::kDoor:
    case ElementKind::kTimed:
      return open_.has(*element);
    case ElementKind::kHazard:
    case ElementKind::kPlate:
      return false;
    case ElementKind::kCheckpoint:
    case ElementKind::kKey:
      return true;
  }
  return false;
}

}  // namespace platon
