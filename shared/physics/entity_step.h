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

/// Moves one entity by one tick. The stages, in this order: turn; then leg by leg until the displacement is used up:
/// admit the instances that the leg needs and find the earliest hit of any of them, choose the lattice point to move
/// to, move all instances, call the rules in the order of time, choose the way on (along the line, for as long as it
/// touches), pass home, drop instances. Each entity has its own, kept between steps for its buffers, and for its
/// instances where they are still what the state says.
class EntityStep {
 public:
  /// I2: a step ends after this many legs at most; a displacement that needs more is cut short.
  static constexpr int kMaxLegs = 64;
  /// I3: the end of a line that stands out by no more than this is passed, not hit. Two ends that are meant to join,
  /// each off by up to 2 subunits along both axes, are up to 5.7 apart.
  static constexpr std::int32_t kNudge = 6;

  /// Prepares for an entity that is in a part. Everything handed over must live until `finish`.
  struct Setting {
    const Geometry& geometry;
    const Convex& base;
    ShapeCache& shapes;
    std::vector<Region>& regions;
    Rules& rules;
    StepObserver* observer;
  };
  void begin(Entity entity, EntityState& state, std::span<const InstanceState> further, const Setting& setting);
  void turn(std::int32_t centidegrees);
  /// By `velocity`, which `heading` turns into the frame of the home part.
  void translate(Point velocity, Angle heading);
  /// Adds the instances that the shape reaches where it stands. False when one cannot be placed.
  bool settle();
  /// Whether no instance overlaps a blocking line.
  bool isFree() { return collider_.isFree(instances_, instances_.home().position, instances_.home().position); }
  /// Hands everything back; `further` gets the instances beyond home.
  void store(std::vector<InstanceState>& further) const { instances_.store(*state_, further); }
  /// Calls the contacts that last and stores.
  void finish(std::vector<InstanceState>& further);
  /// All that the rules have been told of since `begin`.
  std::span<const Contact> contacts() const { return contacts_; }

 private:
  // What is closer to a line than this touches it, as far as the lattice can tell.
  static constexpr std::int32_t kPlay = 2;
  // An instance comes into being before its part is reached: when the shape, grown by this, meets the warp.
  static constexpr std::int32_t kInsertMargin = 4;

  enum class End : std::uint8_t {
    kReached,
    kStopped,  // by a blocking line
    kRefused,  // an instance it needs cannot be placed
    kFull,     // it needs more instances than there may be at once
  };
  struct Leg {
    Point target;
    End end = End::kReached;
    std::optional<LegHit> hit;  // the line, or the warp line, that ends it
  };
  /// Where the next leg is to lead.
  struct Way {
    Point part;   // as far as the line that it slides along goes
    Point whole;  // if that line went on for ever
    bool slides = false;
  };
  struct Event {
    Fraction time;
    bool begins;
    std::size_t placement;
    std::uint32_t line;
  };

  void takeVelocity(Point velocity, Angle heading);
  void keepRemainder();
  Leg admit(Point target);
  void insertBehind(Leg& leg, const LegHit& met);
  bool leadsAway(const LegHit& met, Point target) const;
  Point inRange(Point target) const;
  bool allInRange(Point home) const;
  bool isFarFromEnds(Point home) const;
  void follow(const Leg& leg, const Way& way);
  void moveAlong(const Way& way, Point end);
  Point restAfter(const Way& way, Point moved) const;
  Point stopBefore(const LegHit& hit, Point displacement);
  std::optional<Point> firstFree(Point candidate, Point outwards, Point displacement);
  Point normalOf(const LegHit& hit) const;
  Point homeNormalOf(const LegHit& hit) const;
  void passHome();
  void turnFrame(Angle turn);

  // entity_step_slide.cpp
  Way nextWay();
  bool outreaches(const LegHit& stop, bool back) const;
  Reach reachOf(const LegHit& stop, bool back) const;
  Point outOf(const LegHit& stop, Point slid) const;
  Point slideDirection(const LegHit& hit) const;
  bool leadsBack(const LegHit& line) const;
  bool isWedge(const LegHit& next, Point end) const;
  void restIn(const LegHit& next, const Way& way);
  Point shortOfTurning(Point target);
  bool isTurnedBack(Point end);
  static bool isApart(Point normal, Point way);
  static bool isSameLine(const LegHit& a, const std::optional<LegHit>& b);

  // entity_step_ends.cpp
  bool tryToPass(const Leg& leg, const Way& way, Point reached);
  std::optional<LegHit> groundBehind(const LegHit& end, Point target, Point reached);
  bool passAlong(const LegHit& end, const LegHit& ground, const Way& way, Point reached);
  bool nudgePast(const LegHit& end, const Way& onwards, Point reached, Point left);
  std::optional<Point> nudge(const LegHit& hit, Point target, Point reached);
  bool grazes(const LegHit& hit, Point target, Point reached) const;
  bool leadsOn(const LegHit& end, Point from, Point to);
  bool meetsAtOnce(const LegHit& end, Point from, Point to);
  static bool isAtOnce(const Hit& hit, Point displacement);
  Point fromEnd(const LegHit& end) const;

  void moveTo(Point position);
  Point position() const { return instances_.home().position; }
  void observe();

  // entity_step_turn.cpp
  bool tryTurn(std::int32_t centidegrees);
  void turnBy(std::int32_t centidegrees);
  SegmentRef refOf(const Collider::Pierced& pierced) const;
  std::optional<SegmentRef> turnBlocker(std::int32_t centidegrees, std::size_t from);
  bool admitTurn(std::int32_t centidegrees);

  // entity_step_rules.cpp
  void callPierced(Point before);
  void appendEvents(const Collider::Pierced& pierced, Point before);
  void callContact(const LegHit& hit);
  void callOver();
  void appendOverlap(const Collider::Pierced& pierced);
  bool overlaps(const Placement& placement, std::uint32_t line);

  std::optional<Entity> entity_;
  EntityState* state_ = nullptr;
  Rules* rules_ = nullptr;
  StepObserver* observer_ = nullptr;
  Point wanted_;            // the whole displacement, in the frame of the present home
  Point rest_;              // what is left of it
  PrecisePoint remainder_;  // what rounding has left of position and rest
  bool isFree_ = true;      // nothing was in the way in this step
  Instances instances_;
  Collider collider_;
  std::vector<Collider::Gate> shut_;              // warps that nothing could be inserted behind, for the present leg
  std::optional<Way> onwards_;                    // where to after a nudge
  std::optional<LegHit> slidAlong_;               // the last slide
  std::optional<LegHit> stopBefore_;              // another one, where it has not moved since
  std::optional<LegHit> stop_;                    // what has stopped the entity where it stands
  std::vector<Collider::Pierced> piercedBefore_;  // a part of a turn
  std::vector<Collider::Pierced> piercedAfter_;
  std::vector<Contact> contacts_;
  std::vector<Event> events_;
  std::vector<InstanceView> views_;
};

}  // namespace platon
