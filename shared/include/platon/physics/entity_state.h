#pragma once

#include <cstdint>

#include "platon/exact/angle.h"
#include "platon/exact/point.h"

namespace platon {

/// Every velocity is below this in magnitude, subunits a tick.
inline constexpr std::int32_t kVelocityLimit = std::int32_t{1} << 28;

/// True when `velocity` may be an entity's.
constexpr bool isVelocity(Point velocity) {
  return velocity.x > -kVelocityLimit && velocity.x < kVelocityLimit && velocity.y > -kVelocityLimit &&
         velocity.y < kVelocityLimit;
}

/// An instance of an entity beyond its home. Its position is `anchor + (home position - homeAnchor)` turned by the
/// difference of the two angles and rounded, so that rounding never accumulates.
struct InstanceState {
  static constexpr std::uint16_t kNoParent = 0xffff;

  std::uint32_t part = 0;
  Angle angle;                       ///< of the shape in this part's frame
  Point homeAnchor;                  ///< in the home part's frame
  Point anchor;                      ///< the same point in this part's frame
  std::uint16_t id = 0;              ///< stable while the instance lives
  std::uint16_t parent = kNoParent;  ///< id of the instance it hangs on; none when placed by hand
  std::uint16_t warp = 0;            ///< index of the warp in the parent's part that leads here
  std::uint16_t fresh = 0;           ///< 1 until the first step after it was placed by hand

  friend bool operator==(const InstanceState&, const InstanceState&) = default;

  /// Every field by name, in the order in which it is hashed and saved.
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

/// Takes the first id from `next` on that is not `used` by an instance of the entity. Ids come round again after 65 535
/// instances; kNoParent is none.
template <class Used>
std::uint16_t takeId(std::uint16_t& next, Used&& used) {
  const auto after = [](std::uint16_t id) { return static_cast<std::uint16_t>((id + 1) % InstanceState::kNoParent); };
  while (used(next)) next = after(next);
  const std::uint16_t taken = next;
  next = after(taken);
  return taken;
}

/// All of an entity that is saved and hashed, but for its further instances.
struct EntityState {
  std::uint32_t shape = 0;      ///< index into the world's shapes
  std::uint32_t part = 0;       ///< home part
  Point position;               ///< in the home part's frame, subunits
  Point velocity;               ///< subunits a tick; turned by `heading` it is in the home part's frame
  Point remainder;              ///< what rounding to the lattice has left, in 65 536ths of a subunit: free
                                ///< ways over edges would drift without it; 0 after any contact
  Angle heading;                ///< the turns of all crossings since the velocity was set: never rounded
  Angle angle;                  ///< of the shape in the home part's frame
  std::int32_t turn = 0;        ///< still to be turned at the next step, centidegrees
  std::uint16_t id = 0;         ///< of the home instance
  std::uint16_t nextId = 0;     ///< for the next instance
  std::uint16_t instances = 0;  ///< number of further instances
  std::uint16_t inserted = 0;   ///< 0 while the entity is in no part
  std::uint16_t fresh = 0;      ///< 1 until the first step after it was placed by hand
  std::uint32_t crossings = 0;  ///< times that home has passed to another part

  friend bool operator==(const EntityState&, const EntityState&) = default;

  /// Every field by name, in the order in which it is hashed and saved.
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

/// The greatest remainder: an instance stands off its true place by 4 subunits at most, and roundings add less than 1
/// each.
inline constexpr std::int32_t kRemainderLimit = 8 << 16;

}  // namespace platon
