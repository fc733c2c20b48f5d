// Validation of a state of unknown origin.
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

// An instance that may be the parent of others.
struct Parent {
  std::uint16_t id;
  std::uint32_t part;
  Angle angle;
};

// Whether the chain of parents of every instance leads to the home instance or to one placed by MapPart::insert.
// Rejects cycles. Instances may be stored in any order.
bool isConnected(const Geometry& geometry, const EntityState& entity, std::span<const InstanceState> instances) {
  std::vector<Parent> known{{entity.id, entity.part, entity.angle}};
  std::vector<const InstanceState*> open;
  for (const InstanceState& instance : instances) open.push_back(&instance);
  const auto connect = [&](const InstanceState* instance) {
    const bool isRoot = instance->parent == InstanceState::kNoParent;
    const bool fits = isRoot || std::any_of(known.begin(), known.end(), [&](const Parent& parent) {
                        const MapGeometry& part = *geometry.find(parent.part);
                        if (parent.id != instance->parent || instance->warp >= part.warps.size()) return false;
                        const Warp& warp = part.warps[instance->warp];
                        return warp.target == instance->part && geometry.reverseWarp(part.id, warp) &&
                               parent.angle + warp.turn == instance->angle;
                      });
    if (fits) known.push_back({instance->id, instance->part, instance->angle});
    return fits;
  };
  while (std::erase_if(open, connect) != 0) {
  }
  return open.empty();
}

bool acceptsInstance(const Geometry& geometry, const EntityState& entity, const InstanceState& instance) {
  if (geometry.find(instance.part) == nullptr || !isFlag(instance.fresh)) return false;
  return inRange(instance.homeAnchor) && inRange(instance.anchor) &&
         inRange(instance.anchor + rotate(entity.position - instance.homeAnchor, instance.angle - entity.angle));
}

bool hasUniqueIds(const EntityState& entity, std::span<const InstanceState> instances) {
  std::vector<std::uint16_t> ids{entity.id};
  for (const InstanceState& instance : instances) ids.push_back(instance.id);
  std::sort(ids.begin(), ids.end());
  return std::adjacent_find(ids.begin(), ids.end()) == ids.end() && ids.back() != InstanceState::kNoParent;
}

bool isShapeValid(const Convex& shape, const EntityState& entity, std::span<const InstanceState> instances) {
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
  return hasUniqueIds(entity, instances) && std::all_of(instances.begin(), instances.end(), accepted) &&
         isShapeValid(shape, entity, instances) && isConnected(geometry, entity, instances);
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
