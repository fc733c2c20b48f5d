#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "platon/exact/angle.h"
#include "platon/exact/fraction.h"
#include "platon/exact/point.h"
#include "platon/exact/precise_point.h"
#include "platon/physics/entity_state.h"
#include "platon/physics/step_observer.h"
#include "shared/physics/collider.h"
#include "shared/physics/instances.h"
#include "shared/physics/step/step_events.h"

namespace platon {

struct StepLimits {
  /// I2: limit of legs in a step, and of moves of the position. The remaining displacement is discarded.
  static constexpr int kMaxLegs = 64;
  /// Limit of moves in a leg: a nudge before it, and a detour of two.
  static constexpr int kMovesOfLeg = 3;
  /// Limit of successive slides without progress: more edges than meet at a place in any sensible map.
  static constexpr int kMaxIdleLegs = 8;
};

/// The displacement of a leg, of the ideal place.
struct LegPlan {
  PrecisePoint displacement;  ///< ends with the edge that the leg slides along
  Fraction share{1, 1};       ///< of the remaining displacement, that it uses
  bool slides = false;        ///< along the contact
  bool cut = false;           ///< it ends with the edge
};

/// The begin or end of a contact with a pierced segment.
struct ContactChange {
  Fraction time;
  bool begins;
  std::size_t placement;  ///< Placement::kNone when the instance no longer exists
  SegmentRef segment;
};

/// Work space of steps, which are taken in turn. Keeps its memory between them.
struct StepBuffers {
  std::vector<Collider::WarpRef> refusedWarps;
  std::vector<ContactChange> changes;
  std::vector<InstanceView> views;
};

/// One body in the middle of its step: the ideal path, and the instances, which follow it on the lattice. The stages of
/// a step are functions of this state; it is passed by reference only, and nothing else refers to its parts. Every
/// move, rotation, insertion, rehome and removal of instances goes through its functions, which keep the state of the
/// home instance and the contacts up to date, and report to the observer.
struct StepState {
  // What the step works on, which must outlive it.
  EntityId id;
  EntityState& entity;   ///< a copy of the entity's state in the world
  Instances& instances;  ///< loaded from `entity`
  Collider& collider;    ///< has begun with `instances`
  StepBuffers& buffers;
  StepEvents& events;
  StepObserver* observer;  ///< may be null
  /// A hint, as index of a segment of the home part, or Collider::kNoSegment: at first, what stopped the last step
  /// first; then, what stops this one first.
  std::uint32_t& touched;

  // The start of the step.
  std::size_t firstEvent = events.size();
  Angle headingBefore = entity.heading;
  std::uint16_t firstId = entity.nextId;  ///< of the instances that the step inserts

  // The ideal path: free to the exact contact, then along the exact edge to its exact end. In the frame of the home
  // part, as all places and displacements of a step are, unless it is said otherwise.
  PrecisePoint place = precise(entity.position) + PrecisePoint{entity.remainder.x, entity.remainder.y};
  PrecisePoint tick{};               ///< displacement of the whole tick
  PrecisePoint remaining{};          ///< displacement still to be used; parallel to tick
  std::optional<LegHit> contact{};   ///< the edge that the place is on and was stopped by
  std::optional<LegPlan> passing{};  ///< the next leg, on the free path past a segment end
  int idleLegs = 0;                  ///< successive slides without progress

  // The lattice path.
  int moves = 0;              ///< of the position so far
  bool staysInRange = false;  ///< no instance can reach the coordinate limit in this step

  /// Of the home instance.
  Point position() const { return instances.home().position; }
  /// The lattice point nearest to `ideal`, which is near the position.
  Point roundedAt(PrecisePoint ideal) const { return position() + rounded(ideal - precise(position())); }

  /// Sets the displacement of the tick, all of which remains.
  void setDisplacement(PrecisePoint displacement);
  /// Whether all instances are within the coordinate limit when the home instance is at `home`.
  bool allInRange(Point home) const { return staysInRange || isEachInRange(home); }
  /// Whether no instance hits a blocking segment on the straight way from `from` to `to`.
  bool isFree(Point from, Point to) { return collider.isFree(instances, from, to); }
  /// Whether `at` is the position, or is in range and the straight way to it is free. Requires that the instances have
  /// not moved since findLeg. Fast near the leg.
  bool isReachable(Point at) {
    return at == position() || (allInRange(at) && collider.isFreeInLeg(instances, at) && mayBeAt(at));
  }
  /// Whether the body can be at `at`, where its centre may be in another part: in narrow places no arrangement of the
  /// instances may be near enough to the exact one.
  bool mayBeAt(Point at) { return instances.mayBeAt(at, collider); }
  /// Moves the home instance straight to `to`, and all others with it. The caller has proved that the way is free (I1).
  void moveTo(Point to);

  /// Inserts the instance behind a warp of a placement. Returns false when it cannot be placed.
  bool insertBehind(std::size_t placement, std::uint16_t warp);
  /// Makes the instances into whose parts the centre has crossed the home instance, one after the other, and turns the
  /// ideal path with the frame. A contact is lost when the frame changes.
  void rehome();
  /// Removes the instances that the shape no longer reaches.
  void dropUnreached();
  /// Rotates the shapes of all instances, which the caller has proved to be free.
  void rotateShapes(std::int32_t centidegrees);

  /// Reports all instances to the observer.
  void observe() {
    if (observer != nullptr) report();
  }
  /// Writes the state of the entity and appends its further instances to `further`.
  void store(std::vector<InstanceState>& further) const { instances.store(entity, further); }

 private:
  bool isFarFromLimit() const;
  bool isEachInRange(Point home) const;
  void rotateFrame(Angle turn);
  void report();
};

}  // namespace platon
