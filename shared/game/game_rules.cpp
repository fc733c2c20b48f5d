#include "shared/game/game_rules.h"

#include "platon/physics/entity.h"

namespace platon {
namespace {

// Whether the player touches an end of the segment, not its side.
bool isAtEnd(const Contact& contact) {
  return dot(contact.normal, contact.segment.ends.b - contact.segment.ends.a) != 0 ||
         contact.segment.ends.a == contact.segment.ends.b;
}

}  // namespace

GameRules::GameRules(const Level& level, World& world, std::vector<PlayerState>& players, UnitNormals& unitNormals,
                     TouchedElements& touched, OpenElements open)
    : ElementRules(level, open), world_(world), players_(players), unitNormals_(unitNormals), touched_(touched) {
  world_.setRules(*this);
}

void GameRules::touch(const Entity& entity, const SegmentRef& segment) {
  const Element* const element = elementOf(segment);
  if (element == nullptr || !entity.exists()) return;
  switch (element->kind) {
    case ElementKind::kKey:
      touched_.keys |= element->bit();
      return;
    case ElementKind::kCheckpoint: {
      PlayerState& player = players_[entity.index()];
      player.checkpoint = static_cast<std::uint16_t>(1 + (element - elements().data()));
      player.checkpointUp = upOnFaceOf(segment, entity);
      return;
    }
    case ElementKind::kOneway:
    case ElementKind::kUp:
    case ElementKind::kHazard:
    case ElementKind::kDoor:
    case ElementKind::kPlate:
    case ElementKind::kTimed:
      return;
  }
}

void GameRules::contact(Entity& entity, const Contact& contact) {
  if (entity.index() != moved_) steep_ = Point();
  moved_ = entity.index();
  Player player(world_, moved_, players_[moved_]);
  const Point normal = unitNormals_.of(contact.normal, contact.segment.toHome - player.up());
  if (!elements().empty()) standOrHurt(entity, contact, normal);
  player.contact(normal, isAtEnd(contact), steep_);
}

void GameRules::standOrHurt(const Entity& entity, const Contact& contact, Point normal) {
  const Element* const element = elementOf(contact.segment);
  if (element == nullptr) return;
  switch (element->kind) {
    case ElementKind::kPlate:
      if (Player::isGround(normal)) touched_.plates |= element->bit();
      return;
    case ElementKind::kHazard: {
      std::vector<std::uint32_t>& hurt = touched_.atHazard;
      if (hurt.empty() || hurt.back() != entity.index()) hurt.push_back(entity.index());
      return;
    }
    case ElementKind::kOneway:
    case ElementKind::kUp:
    case ElementKind::kCheckpoint:
    case ElementKind::kKey:
    case ElementKind::kDoor:
    case ElementKind::kTimed:
      return;
  }
}

}  // namespace platon
