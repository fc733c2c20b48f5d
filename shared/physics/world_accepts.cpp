// Validation of a map, and of a state of unknown origin.
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

// What is wrong with the values of a further instance, or null.
const char* valueFaultOf(const Geometry& geometry, const EntityState& entity, const InstanceState& instance) {
  if (geometry.find(instance.part) == nullptr) return "part is not an initialised map part";
  if (!inRange(instance.homeAnchor))
    return "homeAnchor is out of range: its coordinates must be below 2^29 in magnitude";
  if (!inRange(instance.anchor)) return "anchor is out of range: its coordinates must be below 2^29 in magnitude";
  if (!inRange(positionOf(entity, instance))) return "homeAnchor and anchor lead to a position that is out of range";
  return isFlag(instance.fresh) ? nullptr : "fresh is out of range: it must be 0 or 1";
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

// What is wrong with the values of an entity, or null. Angles are in range by their type.
const char* valueFaultOf(const EntityState& entity) {
  if (!inRange(entity.position)) return "position is out of range: its coordinates must be below 2^29 in magnitude";
  if (!isVelocity(entity.velocity)) return "velocity is out of range: its coordinates must be below 2^28 in magnitude";
  if (!isRemainder(entity.remainder))
    return "remainder is out of range: its coordinates must be at most 2^29 in magnitude";
  if (std::abs(std::int64_t{entity.turn}) >= Angle::kTurn)
    return "turn is out of range: it must be below 36000 in magnitude";
  if (entity.nextId == InstanceState::kNoParent) return "nextId is out of range: it must be below 65535";
  if (!isFlag(entity.inserted)) return "inserted is out of range: it must be 0 or 1";
  return isFlag(entity.fresh) ? nullptr : "fresh is out of range: it must be 0 or 1";
}

// What is wrong with an entity and its instances, all of whose values are in range, or null.
const char* relationFaultOf(const Geometry& geometry, const Convex& shape, const EntityState& entity,
                            std::span<const InstanceState> instances) {
  if (!hasUniqueIds(entity, instances)) return "two of its instances have the same id, or one has the id 65535";
  if (!isShapeValid(shape, entity, instances)) return "its shape is degenerate at the rotation of an instance";
  if (!isConnected(geometry, entity, instances)) return "no warp leads to a further instance from its parent";
  return nullptr;
}

std::string named(std::size_t entity, const std::string& what) {
  return "entity " + std::to_string(entity) + ": " + what;
}

// What is wrong with entity `index`.
std::optional<std::string> faultOf(const Geometry& geometry, const Convex& shape, const EntityState& entity,
                                   std::span<const InstanceState> instances, std::size_t index) {
  if (const char* what = valueFaultOf(entity)) return named(index, what);
  if (entity.inserted == 0 && instances.empty()) return std::nullopt;
  if (entity.inserted == 0) return named(index, "it is in no map part but has further instances");
  if (geometry.find(entity.part) == nullptr) return named(index, "its map part is not initialised");
  if (instances.size() >= Instances::kMax) return named(index, "it has too many instances");
  for (std::size_t i = 0; i < instances.size(); ++i) {
    if (const char* what = valueFaultOf(geometry, entity, instances[i]))
      return named(index, "further instance " + std::to_string(i) + ": " + what);
  }
  if (const char* what = relationFaultOf(geometry, shape, entity, instances)) return named(index, what);
  return std::nullopt;
}

}  // namespace

std::optional<std::string> World::mapFault() const {
  for (const auto& part : geometry_->parts) {
    for (std::size_t i = 0; i < part->warps.size(); ++i) {
      const Warp& warp = part->warps[i];
      if (geometry_->reverseWarp(part->id, warp)) continue;
      const std::string target = "map part " + std::to_string(warp.target);
      return "map part " + std::to_string(part->id) + ", warp " + std::to_string(i) +
             ": it blocks like a wall, since " +
             (geometry_->find(warp.target) == nullptr
                  ? target + " is not initialised"
                  : target + " has no reverse warp: add one there, with the ends of both segments exchanged");
    }
  }
  return std::nullopt;
}

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
    if (auto what = faultOf(*geometry_, *shapes_[entity.shape], entity, instances, i)) return what;
    next += entity.instances;
  }
  if (next != state.instances.size()) return "the state has more further instances than its entities name";
  return std::nullopt;
}

}  // namespace platon
