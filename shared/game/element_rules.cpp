#include "shared/game/element_rules.h"

#include "platon/exact/integer.h"
#include "platon/game/player.h"
#include "platon/game/solid.h"

namespace platon {
namespace {

// How much less than its apothem, in subunits, the centre of a player that stands on a one-way segment may be away from
// it. More than the offset of segments that meet (I3), so that a player who runs onto one does not fall through.
constexpr std::int64_t kOnewaySlack = 64;

// Whether a player with its centre there is on the left of the segment. Bounds: coordinates < 2^27, so that the cross
// product is < 2^56.
bool isLeftOf(const Segment& segment, Point centre) {
  constexpr std::int64_t distance = kPlayerApothem - kOnewaySlack;
  const Point along = segment.b - segment.a;
  const int128 beside = cross(along, centre - segment.a);
  return beside >= 0 && beside * beside >= int128{distance * distance} * squaredLength(along);
}

}  // namespace

ElementRules::ElementRules(const Level& level, std::uint32_t open)
    : elements_(level.elements), edgesPerFace_(PlatonicSolid::of(level.solid).edgesPerFace()), open_(open) {}

bool ElementRules::pierce(const Entity& entity, const SegmentRef& segment) const {
  const Element* const element = elementOf(segment);
  if (element == nullptr) return false;
  switch (element->kind) {
    case ElementKind::kOneway:
      return !isLeftOf(segment.ends, segment.position);
    case ElementKind::kUp:
      return !pointsTo(upOnFaceOf(segment, entity), *element, edgesPerFace_);
    case ElementKind::kDoor:
      return (open_ & element->bit()) != 0;
    default:
      return !canBlock(element->kind);
  }
}

}  // namespace platon
