#pragma once

#include <cstdint>
#include <vector>

#include "platon/game/level.h"
#include "platon/game/player.h"
#include "platon/game/unit_normals.h"
#include "platon/physics/world.h"
#include "shared/game/element_rules.h"

namespace platon {

/// The rules of the world during one tick of a game: passes each contact to the player that has it, and notes what the
/// players touch.
class GameRules : public ElementRules {
 public:
  /// What is touched is added to `touched`. All references must outlive the object, which is the rules of `world` as
  /// long as it exists.
  GameRules(const Level& level, World& world, std::vector<PlayerState>& players, UnitNormals& unitNormals,
            TouchedElements& touched, OpenElements open);
  GameRules(const GameRules&) = delete;
  GameRules& operator=(const GameRules&) = delete;
  ~GameRules() override { world_.resetRules(); }

  void beginContact(Entity& entity, const SegmentRef& segment) override { touch(entity, segment); }
  void overContact(Entity& entity, const SegmentRef& segment) override { touch(entity, segment); }
  void contact(Entity& entity, const Contact& contact) override;

 private:
  void touch(const Entity& entity, const SegmentRef& segment);
  void standOrHurt(const Entity& entity, const Contact& contact, Point normal);

  World& world_;
  std::vector<PlayerState>& players_;
  UnitNormals& unitNormals_;
  TouchedElements& touched_;
  std::uint32_t moved_ = ~std::uint32_t{0};  // slot of the last contact: those of one entity follow each other
  Point steep_;                              // normal of its last contact that was too steep to be ground
};

}  // namespace platon
