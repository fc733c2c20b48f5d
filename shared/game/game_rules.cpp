#include "shared/game/game_rules.h"

#include "platon/exact/integer.h"
#include "platon/game/solid.h"
#include "platon/physics/entity.h"

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

// Whether the player touches an end of the segment, not its side.
bool isAtEnd(const Contact& contact) {
  return dot(contact.normal, contact.segment.ends.b - contact.segment.ends.a) != 0 ||
         contact.segment.ends.a == contact.segment.ends.b;
}

// From the +y of the segment's face to the entity's up.
Angle upOnFaceOf(const SegmentRef& segment, const Entity& entity) { return entity.rotation() - segment.toHome; }

}  // namespace

GameRules::GameRules(const Level& level, World& world, std::vector<PlayerState>& players, UnitNormals& unitNormals,
                     TouchedElements& touched, std::uint32_t open)
    : elements_(level.elements),
      edgesPerFace_(PlatonicSolid::of(level.solid).edgesPerFace()),
      world_(world),
      players_(players),
      unitNormals_(unitNormals),
      touched_(touched),
      open_(open) {
  world_.setRules(*this);
}

bool GameRules::pierce(const Entity& entity, const SegmentRef& segment) const {
  const Element* const element = findElement(elements_, segment.part, segment.index);
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

void GameRules::touch(const Entity& entity, const SegmentRef& segment) {
  const Element* const element = findElement(elements_, segment.part, segment.index);
  if (element == nullptr || !entity.exists()) return;
  if (element->kind == ElementKind::kKey) touched_.keys |= element->bit();
  if (element->kind != ElementKind::kCheckpoint) return;
  PlayerState& player = players_[entity.index()];
  player.checkpoint = static_cast<std::uint16_t>(1 + (element - elements_.data()));
  player.checkpointUp = upOnFaceOf(segment, entity);
}

void GameRules::contact(Entity& entity, const Contact& contact) {
  if (entity.index() != moved_) steep_ = Point();
  moved_ = entity.index();
  Player player(world_, moved_, players_[moved_]);
  const Point normal = unitNormals_.of(contact.normal, contact.segment.toHome - player.up());
  if (!elements_.empty()) standOrHurt(entity, contact, normal);
  player.contact(normal, isAtEnd(contact), steep_);
}

void GameRules::standOrHurt(const Entity& entity, const Contact& contact, Point normal) {
  const Element* const element = findElement(elements_, contact.segment.part, contact.segment.index);
  if (element == nullptr) return;
  if (element->kind == ElementKind::kPlate && Player::isGround(normal)) touched_.plates |= element->bit();
  if (element->kind != ElementKind::kHazard) return;
  std::vector<std::uint32_t>& hurt = touched_.atHazard;
  if (hurt.empty() || hurt.back() != entity.index()) hurt.push_back(entity.index());
}

}  // namespace platon
