// The check of a state that comes from outside.
#include <algorithm>
#include <cstdlib>

#include "platon/exact/integer.h"
#include "platon/physics/world.h"
#include "shared/physics/instances.h"

namespace platon {
namespace {

bool inRange(Point point) { return isCoordinate(point.x) && isCoordinate(point.y); }
bool isRemainder(Point point) {
  return std::abs(std::int64_t{point.x}) <= kRemainderLimit && std::abs(std::int64_t{point.y}) <= kRemainderLimit;
}
bool isFlag(std::uint16_t value) { return value <= 1; }

// Where an instance stands that another one may hang on.
struct Stand {
  std::uint16_t id;
  std::uint32_t part;
  Angle angle;
};

// Instances are stored so that some order of hanging them up exists; a ring has none.
bool hangsTogether(const Geometry& geometry, const EntityState& entity, std::span<const InstanceState> instances) {
  std::vector<Stand> known{{entity.id, entity.part, entity.angle}};
  std::vector<const InstanceState*> open;
  for (const InstanceState& instance : instances) open.push_back(&instance);
  const auto hang = [&](const InstanceState* instance) {
    const bool byHand = instance->parent == InstanceState::kNoParent;
    const bool fits = byHand || std::any_of(known.begin(), known.end(), [&](const Stand& stand) {
                        const MapGeometry& part = *geometry.find(stand.part);
                        if (stand.id != instance->parent || instance->warp >= part.warps.size()) return false;
                        const Warp& warp = part.warps[instance->warp];
                        return warp.target == instance->part && geometry.reverseWarp(part.id, warp) &&
                               stand.angle + warp.turn == instance->angle;
                      });
    if (fits) known.push_back({instance->id, instance->part, instance->angle});
    return fits;
  };
  while (std::erase_if(open, hang) != 0) {
  }
  return open.empty();
}

bool acceptsInstance(const Geometry& geometry, const EntityState& entity, const InstanceState& instance) {
  if (geometry.find(instance.part) == nullptr || !isFlag(instance.fresh)) return false;
  return inRange(instance.homeAnchor) && inRange(instance.anchor) &&
         inRange(instance.anchor + rotate(entity.position - instance.homeAnchor, instance.angle - entity.angle));
}

bool idsDiffer(const EntityState& entity, std::span<const InstanceState> instances) {
  std::vector<std::uint16_t> ids{entity.id};
  for (const InstanceState& instance : instances) ids.push_back(instance.id);
  std::sort(ids.begin(), ids.end());
  return std::adjacent_find(ids.begin(), ids.end()) == ids.end() && ids.back() != InstanceState::kNoParent;
}

bool turns(const Convex& shape, const EntityState& entity, std::span<const InstanceState> instances) {
  return shape.turned(entity.angle) && std::all_of(instances.begin(), instances.end(), [&](const auto& instance) {
           return shape.turned(instance.angle).has_value();
         });
}

bool acceptsEntity(const Geometry& geometry, const Convex& shape, const EntityState& entity,
                   std::span<const InstanceState> instances) {
  if (!isFlag(entity.inserted) || !isFlag(entity.fresh) || entity.nextId == InstanceState::kNoParent) return false;
  if (!isVelocity(entity.velocity) || !inRange(entity.position) || !isRemainder(entity.remainder)) return false;
  if (std::abs(std::int64_t{entity.turn}) >= Angle::kTurn) return false;
  if (entity.inserted == 0) return instances.empty();
  if (geometry.find(entity.part) == nullptr || instances.size() >= Instances::kMax) return false;
  const auto accepted = [&](const InstanceState& instance) { return acceptsInstance(geometry, entity, instance); };
  return idsDiffer(entity, instances) && std::all_of(instances.begin(), instances.end(), accepted) &&
         turns(shape, entity, instances) && hangsTogether(geometry, entity, instances);
}

}  // namespace

bool World::accepts(const WorldState& state) const {
  std::size_t next = 0;
  for (const EntityState& entity : state.entities) {
    if (entity.shape >= shapes_.size() || entity.instances > state.instances.size() - next) return false;
    const auto instances = std::span(state.instances).subspan(next, entity.instances);
    if (!acceptsEntity(*geometry_, *shapes_[entity.shape], entity, instances)) return false;
    next += entity.instances;
  }
  return next == state.instances.size();
}

}  // namespace platon
