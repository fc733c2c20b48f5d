// Validation of a state of unknown origin.
#include <algorithm>
#include <cstdlib>
#include <string>

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
  return inRange(instance.homeAnchor) && inRange(instance.anchor) && inRange(positionOf(entity, instance));
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

bool hasValidValues(const EntityState& entity) {
  if (!isFlag(entity.inserted) || !isFlag(entity.fresh) || entity.nextId == InstanceState::kNoParent) return false;
  if (!isVelocity(entity.velocity) || !inRange(entity.position) || !isRemainder(entity.remainder)) return false;
  return std::abs(std::int64_t{entity.turn}) < Angle::kTurn;
}

// What is wrong with an entity, or null.
const char* faultOf(const Geometry& geometry, const Convex& shape, const EntityState& entity,
                    std::span<const InstanceState> instances) {
  if (!hasValidValues(entity)) return "a value is out of range";
  if (entity.inserted == 0) return instances.empty() ? nullptr : "it is in no map part but has further instances";
  if (geometry.find(entity.part) == nullptr) return "its map part is not initialised";
  if (instances.size() >= Instances::kMax) return "it has too many instances";
  if (!hasUniqueIds(entity, instances)) return "two of its instances have the same id, or one has the id 65535";
  const auto accepted = [&](const InstanceState& instance) { return acceptsInstance(geometry, entity, instance); };
  if (!std::all_of(instances.begin(), instances.end(), accepted))
    return "a further instance is in a map part that is not initialised, or a value of it is out of range";
  if (!isShapeValid(shape, entity, instances)) return "its shape is degenerate at the rotation of an instance";
  if (!isConnected(geometry, entity, instances)) return "no warp leads to a further instance from its parent";
  return nullptr;
}

std::string named(std::size_t entity, const char* what) { return "entity " + std::to_string(entity) + ": " + what; }

}  // namespace

std::optional<std::string> World::fault(const WorldState& state) const {
  if (state.generations.size() > state.entities.size()) return "the state has more generations than entities";
  if (!state.generations.empty() && state.generations.back() == 0)
    return "the last generation of the state is 0: leave it out";
  std::size_t next = 0;
  for (std::size_t i = 0; i < state.entities.size(); ++i) {
    const EntityState& entity = state.entities[i];
    if (WorldState::isDestroyed(state.generationOf(static_cast<std::uint32_t>(i)))) {
      if (entity != EntityState()) return named(i, "it is destroyed, but a value of it is not 0");
      continue;
    }
    if (entity.shape >= shapes_.size()) return named(i, "the world has no such shape");
    if (entity.instances > state.instances.size() - next)
      return named(i, "the state has fewer instances than it names");
    const auto instances = std::span(state.instances).subspan(next, entity.instances);
    if (const char* what = faultOf(*geometry_, *shapes_[entity.shape], entity, instances)) return named(i, what);
    next += entity.instances;
  }
  if (next != state.instances.size()) return "the state has more further instances than its entities name";
  return std::nullopt;
}

}  // namespace platon
