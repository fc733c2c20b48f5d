#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "platon/physics/entity.h"
#include "platon/physics/rules.h"
#include "platon/physics/step_observer.h"
#include "shared/physics/collider.h"
#include "shared/physics/instances.h"
#include "shared/physics/shape_cache.h"
#include "shared/physics/slide.h"

namespace platon {

/// Moves one entity by one tick. The entity is rotated first; then its displacement is used up in legs (straight
/// moves). Stages of a leg, in this order: insert the instances that it needs and find the earliest hit of any
/// instance; choose the lattice point to move to; move all instances; call the rules in order of time; change the home
/// instance if necessary; drop instances that are no longer needed. After a hit, the next leg slides along the segment.
/// Each entity has its own EntityStep, which keeps buffers and instances between ticks.
class EntityStep {
 public:
  /// I2: limit of legs in a step. The remaining displacement is discarded.
  static constexpr int kMaxLegs = 64;
  /// I3: a segment end that protrudes by at most this many subunits does not stop an entity. Two ends at one joint,
  /// each off by up to 2 subunits along both axes, are up to 5.7 subunits apart.
  static constexpr std::int32_t kNudge = 6;

  /// What a step works with. All references must stay valid until `finish`.
  struct Context {
    const Geometry& geometry;
    const Convex& base;
    ShapeCache& shapes;
    std::vector<Region>& regions;
    Region::Work& work;
    Rules& rules;
    StepObserver* observer;
  };
  /// Starts the step of an entity that is in a part.
  void begin(Entity entity, EntityState& state, std::span<const InstanceState> further, const Context& context);
  /// Rotates the entity by `centidegrees`, or as far as no segment blocks it.
  void rotateShape(std::int32_t centidegrees);
  /// Moves the entity by `velocity`, which `heading` rotates into the frame of the home part.
  void translate(Point velocity, Angle heading);
  /// Adds the instances that the shape reaches at its position. Returns false when one cannot be placed.
  bool insertReachedInstances();
  /// Whether no instance overlaps a blocking segment.
  bool isFree() { return collider_.isFree(instances_, instances_.home().position, instances_.home().position); }
  /// Writes the state of the entity and appends its further instances to `further`.
  void store(std::vector<InstanceState>& further) const { instances_.store(*state_, further); }
  /// Calls Rules::overContact for all overlapped segments, then `store`.
  void finish(std::vector<InstanceState>& further);
  /// All contacts reported to the rules since `begin`.
  std::span<const Contact> contacts() const { return contacts_; }

 private:
  // An entity within this distance of a segment, in subunits, counts as touching it: the lattice may have no nearer
  // point.
  static constexpr std::int32_t kContactGap = 2;
  // An instance is inserted when the shape with this margin, in subunits, reaches the warp segment: before the shape
  // enters the part.
  static constexpr std::int32_t kInsertMargin = 4;

  enum class End : std::uint8_t {
    kReached,
    kStopped,  // hit a blocking segment
    kRefused,  // an instance that the leg needs cannot be placed
    kFull,     // the limit of instances is reached
  };
  struct Leg {
    Point target;
    End end = End::kReached;
    std::optional<LegHit> hit;  // the blocking segment or warp segment that ends it
  };
  // The displacement of the next leg.
  struct LegPlan {
    Point displacement;   // ends with the segment that the leg slides along
    Point uncut;          // the same if that segment were infinite
    bool slides = false;  // whether the leg slides along a segment
  };
  struct Event {
    Fraction time;
    bool begins;
    std::size_t placement;
    std::uint32_t segment;
  };

  void startTranslation(Point velocity, Angle heading);
  void storeRemainder();
  Leg prepareLeg(Point target);
  void insertInstanceBehind(Leg& leg, const LegHit& warpHit);
  bool movesAwayFromWarp(const LegHit& warpHit, Point target) const;
  Point clampToRange(Point target) const;
  bool allInRange(Point home) const;
  bool isFarFromLimit(Point home) const;
  void executeLeg(const Leg& leg, const LegPlan& plan);
  void moveAlong(const LegPlan& plan, Point end);
  Point remainingAfter(const LegPlan& plan, Point moved) const;
  Point contactPosition(const LegHit& hit, Point displacement);
  std::optional<Point> firstFree(Point candidate, Point outwards, Point displacement);
  Point normalOf(const LegHit& hit) const;
  Point homeNormalOf(const LegHit& hit) const;
  void rehome();
  void rotateFrame(Angle turn);

  // entity_step_slide.cpp
  LegPlan planLeg();
  bool segmentExtendsBeyondSlide(const LegHit& stop, bool back) const;
  SlideLimits slideLimits(const LegHit& stop, bool back) const;
  Point keepOutside(const LegHit& stop, Point slide) const;
  Point slideDirection(const LegHit& hit) const;
  bool leadsBack(const LegHit& hit) const;
  bool isWedge(const LegHit& next, Point end) const;
  void stopInWedge(const LegHit& next, const LegPlan& plan);
  Point stopBeforeReversal(Point target);
  bool isReversedAt(Point end);
  static bool exceedsContactGap(Point normal, Point displacement);
  static bool isSameSegment(const LegHit& a, const std::optional<LegHit>& b);

  // entity_step_ends.cpp
  bool tryPassEnd(const Leg& leg, const LegPlan& plan, Point reached);
  std::optional<LegHit> groundBehind(const LegHit& end, Point target, Point reached);
  bool passEndAlong(const LegHit& end, const LegHit& ground, const LegPlan& plan, Point reached);
  bool nudgePast(const LegHit& end, const LegPlan& onwards, Point reached, Point remaining);
  std::optional<Point> nudge(const LegHit& hit, Point target, Point reached);
  bool grazes(const LegHit& hit, Point target, Point reached) const;
  bool continuesPast(const LegHit& end, Point from, Point to);
  bool hitsEndAgain(const LegHit& end, Point from, Point to);
  static bool isImmediate(const Hit& hit, Point displacement);
  Point awayFromEnd(const LegHit& end) const;

  void moveTo(Point position);
  Point position() const { return instances_.home().position; }
  void observe();

  // entity_step_rotation.cpp
  bool tryRotation(std::int32_t centidegrees);
  void rotateBy(std::int32_t centidegrees);
  SegmentRef refOf(const Collider::Pierced& pierced) const;
  std::optional<SegmentRef> rotationBlocker(std::int32_t centidegrees, std::size_t from);
  bool insertInstancesForRotation(std::int32_t centidegrees);

  // entity_step_rules.cpp
  void callPierced(Point before);
  void appendEvents(const Collider::Pierced& pierced, Point before);
  void callContact(const LegHit& hit);
  void callOver();
  void appendOverlap(const Collider::Pierced& pierced);
  bool overlaps(const Placement& placement, std::uint32_t segment);

  std::optional<Entity> entity_;
  EntityState* state_ = nullptr;
  Rules* rules_ = nullptr;
  StepObserver* observer_ = nullptr;
  Point tickDisplacement_;    // displacement of the whole tick, in the frame of the current home part
  Point remaining_;           // displacement still to be used
  PrecisePoint remainder_;    // exact position minus lattice position, including the rounding of remaining_
  bool unobstructed_ = true;  // whether nothing was hit in this step
  Instances instances_;
  Collider collider_;
  std::vector<Collider::WarpRef> refusedWarps_;   // warps of this leg behind which no instance can be placed
  std::optional<LegPlan> planAfterNudge_;         // the next leg, after a nudge
  std::optional<LegHit> lastSlide_;               // the segment of the last slide
  std::optional<LegHit> previousStop_;            // the stop before stop_ at the same position
  std::optional<LegHit> stop_;                    // the segment that stopped the entity at its current position
  std::vector<Collider::Pierced> piercedBefore_;  // before and after one part of a rotation
  std::vector<Collider::Pierced> piercedAfter_;
  std::vector<Contact> contacts_;
  std::vector<Event> events_;
  std::vector<InstanceView> views_;
};

}  // namespace platon
