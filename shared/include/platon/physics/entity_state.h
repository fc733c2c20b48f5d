#pragma once

#include <cstdint>

#include "platon/exact/angle.h"
#include "platon/exact/point.h"

namespace platon {

/// The coordinates of a velocity are below this in magnitude, subunits per tick.
inline constexpr std::int32_t kVelocityLimit = std::int32_t{1} << 28;

/// Whether `velocity` is in the range of velocities.
constexpr bool isVelocity(Point velocity) {
  return velocity.x > -kVelocityLimit && velocity.x < kVelocityLimit && velocity.y > -kVelocityLimit &&
         velocity.y < kVelocityLimit;
}

/// Names an entity of a world for as long as it exists. Indices of destroyed entities are used again, for an entity of
/// a later generation.
struct EntityId {
  std::uint32_t index = 0;
  std::uint32_t generation = 0;

  friend bool operator==(const EntityId&, const EntityId&) = default;
};

/// State of an instance other than the home instance (a "further instance"). Its position is `anchor` plus
/// `home position - homeAnchor` rotated by the difference of the two angles and rounded. The position is computed from
/// the anchors in every tick, so rounding errors do not accumulate.
struct InstanceState {
  static constexpr std::uint16_t kNoParent = 0xffff;

  std::uint32_t part = 0;            ///< id of the map part
  Angle angle;                       ///< rotation of the shape in the frame of this part
  Point homeAnchor;                  ///< a position of the home instance, in the frame of the home part
  Point anchor;                      ///< the position of this instance at that time, in the frame of this part
  std::uint16_t id = 0;              ///< constant while the instance exists
  std::uint16_t parent = kNoParent;  ///< id of the parent instance; kNoParent when placed by MapPart::insert
  std::uint16_t warp = 0;            ///< index of the warp from the parent's part to this part
  std::uint16_t fresh = 0;           ///< 1 from MapPart::insert until the next step, else 0

  friend bool operator==(const InstanceState&, const InstanceState&) = default;

  /// Calls `visitor(name, field)` for every field, in the order of hashing and saving.
  template <class State, class Visitor>
  static void visit(State& state, Visitor&& visitor) {
    visitor("part", state.part);
    visitor("angle", state.angle);
    visitor("homeAnchor", state.homeAnchor);
    visitor("anchor", state.anchor);
    visitor("id", state.id);
    visitor("parent", state.parent);
    visitor("warp", state.warp);
    visitor("fresh", state.fresh);
  }
};
static_assert(sizeof(InstanceState) <= 32);

/// Returns the first id, starting at `next`, for which `used` is false, and sets `next` to its successor. Ids wrap
/// round after 65 535; kNoParent is never returned.
template <class Used>
std::uint16_t allocateId(std::uint16_t& next, Used&& used) {
  const auto after = [](std::uint16_t id) { return static_cast<std::uint16_t>((id + 1) % InstanceState::kNoParent); };
  while (used(next)) next = after(next);
  const std::uint16_t taken = next;
  next = after(taken);
  return taken;
}

/// The saved and hashed state of an entity, without its further instances.
struct EntityState {
  std::uint32_t shape = 0;      ///< index into the world's shapes
  std::uint32_t part = 0;       ///< id of the home part
  Point position;               ///< in the frame of the home part, subunits
  Point velocity;               ///< subunits per tick, in a frame rotated by `heading` against the home part
  Point remainder;              ///< exact position minus `position`, in 2^-26 subunits
                                ///< Without it, free motion in a rotated frame would drift
  Angle heading;                ///< rotation from the frame of `velocity` to the frame of the home part
  Angle angle;                  ///< rotation of the shape in the frame of the home part
  std::int32_t turn = 0;        ///< rotation requested for the next step, centidegrees
  std::uint16_t id = 0;         ///< id of the home instance
  std::uint16_t nextId = 0;     ///< first candidate for the id of the next instance
  std::uint16_t instances = 0;  ///< number of further instances
  std::uint16_t inserted = 0;   ///< 1 while the entity is in a map part, else 0
  std::uint16_t fresh = 0;      ///< 1 from MapPart::insert until the next step, else 0
  std::uint32_t crossings = 0;  ///< number of changes of the home part

  friend bool operator==(const EntityState&, const EntityState&) = default;

  /// Calls `visitor(name, field)` for every field, in the order of hashing and saving.
  template <class State, class Visitor>
  static void visit(State& state, Visitor&& visitor) {
    visitor("shape", state.shape);
    visitor("part", state.part);
    visitor("position", state.position);
    visitor("velocity", state.velocity);
    visitor("remainder", state.remainder);
    visitor("heading", state.heading);
    visitor("angle", state.angle);
    visitor("turn", state.turn);
    visitor("id", state.id);
    visitor("nextId", state.nextId);
    visitor("instances", state.instances);
    visitor("inserted", state.inserted);
    visitor("fresh", state.fresh);
    visitor("crossings", state.crossings);
  }
};
static_assert(sizeof(EntityState) <= 128);

/// The position of `instance`, a further instance of the entity with this state, in the frame of the instance's part.
/// Requires that `position`, `homeAnchor` and `anchor` are coordinates (below 2^29 in magnitude).
inline Point positionOf(const EntityState& entity, const InstanceState& instance) {
  return instance.anchor + rotate(entity.position - instance.homeAnchor, instance.angle - entity.angle);
}

/// Bound of a remainder's coordinates, 2^-26 subunits: 8 subunits. An instance is at most 4 subunits from its exact
/// position (I5), and each rounding adds less than 1.
inline constexpr std::int32_t kRemainderLimit = 8 << 26;

}  // namespace platon
