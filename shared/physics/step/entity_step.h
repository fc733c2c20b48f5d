#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "platon/physics/entity.h"
#include "platon/physics/rules.h"
#include "platon/physics/step_observer.h"
#include "shared/physics/collider.h"
#include "shared/physics/ideal_geometry.h"
#include "shared/physics/instances.h"
#include "shared/physics/step/step_events.h"
#include "shared/physics/tolerances.h"

namespace platon {

/// Moves one entity by one tick. The entity is rotated first; then its displacement is used up in legs (straight
/// moves). Stages of a leg, in this order: insert the instances that it needs and find the earliest hit of any
/// instance; choose the lattice point to move to; move all instances; add the events in order of time; change the home
/// instance if necessary; drop instances that are no longer needed. After a hit, the next leg slides along the segment.
class EntityStep {
  // The begin or end of a contact.
  struct Change {
    Fraction time;
    bool begins;
    std::size_t placement;  // Placement::kNone when the instance no longer exists
    SegmentRef segment;
  };

 public:
  /// Work space of steps, which are taken in turn. Keeps its memory between them.
  struct Buffers {
    Collider collider;
    std::vector<Collider::WarpRef> refusedWarps;
    std::vector<Change> changes;
    std::vector<InstanceView> views;
  };

  /// I2: limit of legs in a step, and of moves of the position. The remaining displacement is discarded.
  static constexpr int kMaxLegs = 64;
  /// Limit of moves in a leg: a detour has two.
  static constexpr int kMovesOfLeg = 2;
  static constexpr std::int32_t kNudge = Tolerances::kNudge;
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
  };
  /// Starts the step of an entity that is in a part. `instances` have been loaded from `state`. The step changes both,
  /// not the entity's state in its world.
  EntityStep(Entity entity, EntityState& state, Instances& instances, const Context& context);
  EntityStep(const EntityStep&) = delete;
  EntityStep& operator=(const EntityStep&) = delete;

  /// Lets all instances but `except` pass what they overlap, until they have left it.
  void pierceOverlapped(std::uint16_t except = InstanceState::kNoParent);
  /// As above, for all instances. The contacts of fresh instances begin.
  void beginContacts();
  /// Appends the contacts that have begun, after pierceOverlapped: those of instances that are not fresh.
  void appendContacts(std::vector<SegmentRef>& out) const;
  /// Rotates the entity by `centidegrees`, or as far as no segment blocks it.
  void rotateShape(std::int32_t centidegrees);
  /// Moves the entity by `velocity`, which `heading` rotates into the frame of the home part.
  void translate(Point velocity, Angle heading);
  /// Adds the instances that the shape reaches at its position. Returns false when one cannot be placed.
  bool insertReachedInstances();
  /// Whether no instance overlaps a blocking segment.
  bool isFree() { return collider_.isFree(instances_, instances_.home().position, instances_.home().position); }
  /// Writes the state of the entity and appends its further instances to `further`.
  void store(std::vector<InstanceState>& further) const { instances_.store(state_, further); }
  /// Adds overContact for all overlapped segments, then `store`.
  void finish(std::vector<InstanceState>& further);

 private:
  enum class End : std::uint8_t {
    kReached,
    kStopped,  // hit a blocking segment
    kRefused,  // an instance that the leg needs cannot be placed
    kFull,     // the limit of instances is reached
  };
  // The displacement of the next leg, of the ideal place.
  struct LegPlan {
    PrecisePoint displacement;  // ends with the edge that the leg slides along
    Fraction share{1, 1};       // of the remaining displacement, that it uses
    bool slides = false;        // along contact_
    bool cut = false;           // it ends with the edge
  };
  struct Leg {
    PrecisePoint displacement{};
    bool slides = false;   // along contact_, whose obstacle it cannot enter
    Point target{};        // of the lattice position, if nothing is hit
    Fraction share{1, 1};  // of the planned displacement: less if that leads out of the coordinates
    End end = End::kReached;
    std::optional<LegHit> hit{};  // the blocking segment or warp segment that ends it
  };

  void storeRemainder();
  void prepareLeg(Leg& leg);
  void findHit(Leg& leg);
  void findHit(Leg& leg, std::size_t placement);
  bool clampToRange(Leg& leg) const;
  void insertInstanceBehind(Leg& leg, const LegHit& warpHit);
  void stopAtWarp(Leg& leg, const LegHit& warpHit, End end);
  bool movesAwayFromWarp(const LegHit& warpHit, Point target) const;
  bool allInRange(Point home) const { return staysInRange_ || isEachInRange(home); }
  bool isEachInRange(Point home) const;
  bool staysInRange() const;
  void executeLeg(Leg& leg, const LegPlan& plan);
  void stopInWedge(const LegHit& hit, PrecisePoint rest);
  PrecisePoint endOf(const Leg& leg, const LegPlan& plan) const;
  PrecisePoint onto(const LegHit& hit, PrecisePoint place) const;
  PrecisePoint restAfter(const Leg& leg, const LegPlan& plan) const;
  Point normalOf(const LegHit& hit) const;
  Point homeNormalOf(const LegHit& hit) const;
  void rehome();
  void dropUnreached();
  void rotateFrame(Angle turn);

  // entity_step_follow.cpp
  bool follow(PrecisePoint end, const Leg& leg);
  bool followFarther(PrecisePoint end, const Leg& leg);
  std::optional<Point> nearestReachable(PrecisePoint end, const Leg& leg);
  bool isReachable(Point place);
  bool isBetter(Point offset, Point other, const Leg& leg) const;
  bool mayStandAt(Point place, const Leg& leg) const;
  bool followByDetour(PrecisePoint end, const Leg& leg, std::optional<Point> straight);
  bool fallBack(PrecisePoint end);

  // entity_step_slide.cpp
  // A displacement in the frame of the part whose edge was hit, and back.
  PrecisePoint fromHome(const LegHit& hit, PrecisePoint vector) const {
    return hit.placement == 0 ? vector : rotated(vector, instances_.all()[hit.placement].fromHome);
  }
  PrecisePoint toHome(const LegHit& hit, PrecisePoint vector) const {
    return hit.placement == 0 ? vector : rotated(vector, instances_.all()[hit.placement].toHome);
  }
  LegPlan planLeg();
  IdealSlide slideFrom(const LegHit& hit, PrecisePoint place, PrecisePoint rest) const;
  LegPlan planSlide(const LegHit& hit) const;
  PrecisePoint slideWithoutEnd(const LegHit& hit) const;
  bool restsOn(const LegHit& hit) const;
  bool isWedged(const LegHit& hit);
  bool leadsInto(PrecisePoint displacement, const LegHit& contact) const;
  void turnCorner(LegHit& hit, PrecisePoint place) const;
  static bool isSameEdge(const LegHit& a, const LegHit& b);

  // entity_step_ends.cpp
  bool isBlockedByEnd(const LegHit& hit, PrecisePoint place, PrecisePoint rest) const;
  int128 squaredSlide(const LegHit& hit) const;
  bool touchesEnd(LegHit& hit, PrecisePoint place) const;
  bool passEnd(LegHit end, Point normal, PrecisePoint from, PrecisePoint rest);
  std::optional<Point> nudge(const LegHit& hit, Point target, Point reached);
  bool isAtJoint(const LegHit& hit);
  bool grazes(const LegHit& hit, Point target, Point reached) const;
  bool continuesPast(const LegHit& end, Point from, Point to);
  bool hitsEndAgain(const LegHit& end, Point from, Point to);
  static bool isImmediate(const Hit& hit, Point displacement);
  Point awayFromEnd(const LegHit& end) const;

  void moveTo(Point position);
  Point roundedAt(PrecisePoint place) const { return position() + rounded(place - precise(position())); }
  Point position() const { return instances_.home().position; }
  void observe() {
    if (observer_ != nullptr) report();
  }
  void report();

  // entity_step_rotation.cpp
  bool tryRotation(std::int32_t centidegrees);
  void rotateBy(std::int32_t centidegrees);
  std::optional<SegmentRef> rotationBlocker(std::int32_t centidegrees, std::size_t from);
  bool insertInstancesForRotation(std::int32_t centidegrees);

  // entity_step_rules.cpp
  void addEvent(StepEvents::Kind kind, const SegmentRef& segment) { events_.add(kind, entity_.id()).segment = segment; }
  void addContact(const LegHit& hit);
  void addOver();
  void followContacts(Point before);
  void updateContacts();
  void appendChanges(const SegmentRef& pierced, Point before);
  void applyChanges();
  std::size_t placementOf(const SegmentRef& ref) const;
  void clearFresh();

  Entity entity_;
  EntityState& state_;
  StepEvents& events_;
  std::size_t firstEvent_;  // of this step
  Angle headingBefore_;     // of the entity at the start of the step
  StepObserver* observer_;
  PrecisePoint tick_;   // displacement of the whole tick, in the frame of the current home part
  PrecisePoint rest_;   // displacement still to be used; parallel to tick_
  PrecisePoint ideal_;  // the ideal place of the home instance
  Instances& instances_;
  Collider& collider_;
  std::vector<Collider::WarpRef>& refusedWarps_;  // warps of this leg behind which no instance can be placed
  std::vector<Change>& changes_;
  std::vector<InstanceView>& views_;
  std::optional<LegPlan> planAfterNudge_;  // the next leg, after a nudge
  std::optional<LegHit> contact_;          // the edge that the ideal place is on and was stopped by
  bool staysInRange_ = false;              // fast path of allInRange
  int idleLegs_ = 0;                       // successive slides without progress
  int moves_ = 0;                          // of the position
};

}  // namespace platon
