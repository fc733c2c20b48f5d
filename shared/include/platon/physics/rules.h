#pragma once

#include <cstdint>

#include "platon/exact/fraction.h"
#include "platon/exact/point.h"
#include "platon/physics/entity.h"
#include "platon/physics/segment.h"

namespace platon {

/// A segment of a map part that an instance of an entity meets, as passed to rules.
struct SegmentRef {
  std::uint32_t part = 0;   ///< id of the map part
  std::uint32_t index = 0;  ///< order of MapPart::line calls, followed by the warps in order of MapPart::warp calls
  bool warp = false;        ///< whether the segment belongs to a warp
  Segment ends;             ///< in the frame of the part

  std::uint16_t instance = 0;  ///< id of the entity's instance in the part
  Angle toHome = {};           ///< added to an angle in the frame of the part, gives the angle in that of the home part
  Point position = {};         ///< for Rules::pierce: of the instance, in the frame of the part, before the next move
  std::uint32_t tag = 0;       ///< of MapPart::line; 0 for warps
};

/// A collision of an entity with a blocking segment.
struct Contact {
  SegmentRef segment;
  Point point;    ///< point of contact in the frame of the segment's part, to the nearest subunit
  Point normal;   ///< exact direction from the segment to the entity, in the frame of the segment's part. Not (0, 0),
                  ///< coordinates below 2^30 in magnitude (kNormalLimit), so that squaredLength(normal) is below 2^61
                  ///< and dot(velocity, normal) below 2^59. For a bounce, see reflect()
  Fraction time;  ///< fraction of the leg, in [0, 1)
};

/// Decides which segments block, and receives the events of a step.
///
/// The events are delivered by World::solve after all entities have moved: those of the first entity, then those of the
/// next one, each called a callback. The events of an entity come in the order in which they happened: those of its
/// rotation, then those of each leg in order of time, then overContact. Events at equal times are ordered by instance
/// (home first, then by age), then by segment index. `toHome` of their segments leads to the home part after the step.
///
/// beginContact and endContact alternate for an entity, an instance and a segment, as long as the same rules are set. A
/// contact also ends when its instance is dropped or removed: MapPart::insert and erase, World::erase and destroy
/// deliver endContact, at once or, called by a callback, after the events that wait. The contacts of an instance that
/// MapPart::insert places begin in the next step. A state that World::restore or an assignment brings in is taken as it
/// is: contacts with what an instance overlaps there have begun, unless the instance is fresh (InstanceState::fresh).
///
/// A callback may change the world: add, insert, erase, destroy and rotate entities, change velocities,
/// initialise parts, set other rules. Events that wait are delivered all the same. They describe the step: their entity
/// may have been erased or changed since. Of a destroyed entity, only beginContact and endContact are still delivered,
/// so that they alternate: Entity::exists is false then, and only the id of the handle can be used. A callback may not
/// solve the world, restore it or assign to it: these throw std::logic_error. When a callback throws, the events that
/// wait are dropped, and the exception passes on; the step itself is complete, and the world can go on. They are also
/// dropped when a callback moves the world elsewhere. It must not destroy the world.
///
/// A program that rolls back and steps again must call those callbacks again that change the world or the state of the
/// program, and restore that state with the world. Only those without such an effect, as sounds, may be left out.
class Rules {
 public:
  virtual ~Rules() = default;

  /// Whether the entity passes through the segment. Asked during a step, for segments near the path only, and by
  /// MapPart::insert. Must depend only on the arguments and the state of the world, which is that before the step or
  /// the insertion: Entity::velocity is in the frame of the home part, to which `segment.toHome` leads. So
  /// rotate(entity.velocity(), -segment.toHome) is the velocity in the frame of the segment. The world may be read but
  /// not changed: that throws std::logic_error. When `pierce` throws, the step or insertion has no effect.
  ///
  /// A segment that an instance overlaps at the start of a step, or since an earlier move of the step, is pierced
  /// without asking, until the instance has left it. Then it is asked again, even in the same step. So a segment that
  /// ceases to be pierceable lets those out that are in it. Default: warps can be passed, other segments block.
  virtual bool pierce(const Entity& entity, const SegmentRef& segment) const;

  /// For which segments `pierce` is called, and which callbacks are. Less is faster.
  enum class Scope : std::uint8_t {
    kEverything,  ///< `pierce` is called for all segments, and all callbacks
    kSegments,    ///< as above, but not for warps: they can always be passed, and no callback tells
    kContacts     ///< `pierce` is never called: warps can be passed, other segments block, even an entity that overlaps
                  ///< them, which then cannot leave. Of the callbacks, only contact and touchContact are called
  };
  /// Asked at the start of each step. Default: everything.
  virtual Scope scope() const { return Scope::kEverything; }

  /// Whether `pierce` can ever return true for segment `index` of map part `part` (SegmentRef::part and index). Where
  /// this returns false, the step does not call `pierce` and is faster, most of all for an entity that rests on such
  /// segments alone. Must depend only on the arguments. Called with Scope::kSegments only, and not for warps. Default:
  /// true.
  virtual bool mayPierce(std::uint32_t part, std::uint32_t index) const;

  /// An instance of the entity begins to overlap a pierced segment.
  virtual void beginContact(Entity& entity, const SegmentRef& segment);
  /// An instance of the entity overlaps a pierced segment at the end of the step.
  virtual void overContact(Entity& entity, const SegmentRef& segment);
  /// An instance of the entity no longer overlaps a pierced segment, or no longer exists.
  virtual void endContact(Entity& entity, const SegmentRef& segment);

  /// A blocking segment stops the entity. The remaining displacement slides along the segment.
  virtual void contact(Entity& entity, const Contact& contact);
  /// A blocking segment stops the rotation of the entity.
  virtual void touchContact(Entity& entity, const SegmentRef& segment);
};

}  // namespace platon
