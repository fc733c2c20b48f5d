#pragma once

#include <cstdint>
#include <vector>

#include "platon/physics/entity.h"
#include "platon/physics/rules.h"
#include "platon/physics/step_observer.h"
#include "shared/physics/collider.h"
#include "shared/physics/instances.h"
#include "shared/physics/step/leg.h"
#include "shared/physics/step/mover.h"
#include "shared/physics/step/slide.h"
#include "shared/physics/step/step_contacts.h"
#include "shared/physics/step/step_events.h"
#include "shared/physics/step/turn_step.h"

namespace platon {

/// Moves one entity by one tick. The entity is rotated first (TurnStep); then its displacement is used up in legs
/// (straight moves). Stages of a leg: plan it (Slide); insert the instances that it needs and find the earliest hit
/// of any instance (prepareLeg); pass a segment end that protrudes (findNudge); move all instances to the lattice point
/// nearest to the ideal place (follow, Mover), which adds the events (StepContacts); change the home instance if
/// necessary; drop instances that are no longer needed.
class EntityStep {
 public:
  /// Work space of steps, which are taken in turn. Keeps its memory between them.
  struct Buffers {
    Collider collider;
    std::vector<Collider::WarpRef> refusedWarps;
    std::vector<StepContacts::Change> changes;
    std::vector<InstanceView> views;
  };

  /// I2: limit of legs in a step, and of moves of the position. The remaining displacement is discarded.
  static constexpr int kMaxLegs = 64;
  /// Limit of moves in a leg: a nudge before it, and a detour of two.
  static constexpr int kMovesOfLeg = 3;
  /// Limit of successive slides without progress: more edges than meet at a place in any sensible map.
  static constexpr int kMaxIdleLegs = 8;

  /// What a step works with besides the entity. All references must stay valid as long as the step.
  struct Context {
    std::vector<Region>& regions;  ///< of the entity
    Region::Work& work;
    Buffers& buffers;
    Rules& rules;
    StepEvents& events;
    StepObserver* observer;
    std::uint32_t& touched;  ///< the segment of the home part that stopped the body first, or Collider::kNoSegment
  };
  /// Starts the step of an entity that is in a part. `instances` have been loaded from `state`. The step changes both,
  /// not the entity's state in its world.
  EntityStep(const Entity& entity, EntityState& state, Instances& instances, const Context& context);
  EntityStep(const EntityStep&) = delete;
  EntityStep& operator=(const EntityStep&) = delete;

  StepContacts& contacts() { return contacts_; }
  /// Rotates the entity by `centidegrees`, or as far as no segment blocks it.
  void rotateShape(std::int32_t centidegrees) { TurnStep(mover_, contacts_).turn(centidegrees); }
  /// Moves the entity by `velocity`, which `heading` rotates into the frame of the home part.
  void translate(Point velocity, Angle heading);
  /// Adds the instances that the shape reaches at its position. Returns false when one cannot be placed.
  bool insertReachedInstances();
  /// Whether no instance overlaps a blocking segment.
  bool isFree() { return mover_.isFree(mover_.position(), mover_.position()); }
  /// Writes the state of the entity and appends its further instances to `further`.
  void store(std::vector<InstanceState>& further) const { mover_.store(further); }
  /// Adds the last events, then `store`.
  void finish(std::vector<InstanceState>& further);

 private:
  bool slideOn();
  LegPlan nextPlan();
  void executeLeg(Leg& leg, const LegPlan& plan);
  void stopInWedge(const LegHit& hit, PrecisePoint remaining);
  bool isWedged(const LegHit& hit);
  bool pass(const LegHit& end, const LegHit& from, PrecisePoint place, PrecisePoint remaining);
  void rehome();
  void storeRemainder();

  EntityState& state_;
  Angle headingBefore_;    // of the entity at the start of the step
  std::uint16_t firstId_;  // of the instances that the step inserts
  std::uint32_t& touched_;
  std::vector<Collider::WarpRef>& refusedWarps_;
  StepContacts contacts_;
  Mover mover_;
  Slide slide_;
  int idleLegs_ = 0;  // successive slides without progress
};

}  // namespace platon
