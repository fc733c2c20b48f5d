#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "platon/physics/entity_state.h"
#include "platon/physics/step_observer.h"
#include "shared/physics/collider.h"
#include "shared/physics/instances.h"
#include "shared/physics/step/step_contacts.h"

namespace platon {

/// Moves all instances of an entity together, on the lattice. Every move, rotation, insertion, rehome and removal of
/// instances in a step goes through it: it keeps the state of the home instance and the contacts up to date, and
/// reports to the observer.
class Mover {
 public:
  /// Who watches the step.
  struct Watch {
    StepObserver* observer;            ///< may be null
    std::uint32_t entity;              ///< its index
    std::vector<InstanceView>& views;  ///< work space
  };

  /// Reports the instances to the observer. They have been loaded from `state`. All references must stay valid as long
  /// as the object.
  Mover(EntityState& state, Instances& instances, Collider& collider, StepContacts& contacts, const Watch& watch)
      : state_(state), instances_(instances), collider_(collider), contacts_(contacts), watch_(watch) {
    observe();
  }

  const Instances& instances() const { return instances_; }
  Instances& instances() { return instances_; }
  Collider& collider() { return collider_; }
  /// Of the home instance, as are all positions below.
  Point position() const { return instances_.home().position; }
  /// The lattice point nearest to `place`, which is near the position.
  Point roundedAt(PrecisePoint place) const { return position() + rounded(place - precise(position())); }
  /// Number of moves of the position so far.
  int moves() const { return moves_; }

  /// Announces a motion by `displacement`, so that allInRange is fast far from the limit.
  void start(PrecisePoint displacement);
  /// Whether all instances are within the coordinate limit when the home instance is at `home`.
  bool allInRange(Point home) const { return staysInRange_ || isEachInRange(home); }
  /// Whether no instance hits a blocking segment on the straight way from `from` to `to`.
  bool isFree(Point from, Point to) { return collider_.isFree(instances_, from, to); }
  /// Whether `place` is the position, or is in range and the straight way to it is free. Requires that the instances
  /// have not moved since prepareLeg. Fast near the leg.
  bool isReachable(Point place) {
    return place == position() || (allInRange(place) && collider_.isFreeInLeg(instances_, place) && mayBeAt(place));
  }
  /// Whether the body can be at `place`, where its centre may be in another part: in narrow places no arrangement of
  /// the instances may be near enough to the exact one.
  bool mayBeAt(Point place) { return instances_.mayBeAt(place, collider_); }
  /// Moves the home instance straight to `position`, and all others with it. The caller has proved that the way is
  /// free (I1).
  void moveTo(Point position);

  /// Inserts the instance behind a warp of a placement. Returns false when it cannot be placed.
  bool insertBehind(std::size_t placement, std::uint16_t warp);
  /// Makes the instance into whose part the centre has crossed the home instance, and converts `place` into its frame.
  /// Returns the rotation between the frames, or nothing when the home instance stays.
  std::optional<Angle> rehome(PrecisePoint& place);
  /// Removes the instances that the shape no longer reaches.
  void dropUnreached();
  /// Rotates the shapes of all instances, which the caller has proved to be free.
  void rotateShapes(std::int32_t centidegrees);

  /// Reports all instances to the observer.
  void observe() {
    if (watch_.observer != nullptr) report();
  }
  /// Writes the state of the entity and appends its further instances to `further`.
  void store(std::vector<InstanceState>& further) const { instances_.store(state_, further); }

 private:
  bool staysInRange() const;
  bool isEachInRange(Point home) const;
  void report();

  EntityState& state_;
  Instances& instances_;
  Collider& collider_;
  StepContacts& contacts_;
  Watch watch_;
  std::int64_t reach_ = 0;     // of the motion, along an axis, in the units of PrecisePoint
  bool staysInRange_ = false;  // fast path of allInRange
  int moves_ = 0;
};

}  // namespace platon
