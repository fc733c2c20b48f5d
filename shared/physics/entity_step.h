#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "shared/physics/collider.h"
#include "shared/physics/entity.h"
#include "shared/physics/instances.h"
#include "shared/physics/rules.h"
#include "shared/physics/shape_cache.h"
#include "shared/physics/step_observer.h"

namespace platon {

/// Moves one entity by one tick. The stages, in this order: turn; then leg by leg until the displacement is used up:
/// admit the instances that the leg needs and find the earliest hit of any of them, choose the lattice point to move
/// to, move all instances, call the rules in the order of time, slide what is left along the line, pass home, drop
/// instances. Kept between steps for its buffers only.
class EntityStep {
 public:
  /// I2: a step ends after this many legs at most; a displacement that needs more is cut short.
  static constexpr int kMostLegs = 64;

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
  void turn(std::int32_t hundredths);
  /// `displacement` in the frame of the home part.
  void translate(Point displacement);
  /// Adds the instances that the shape reaches where it stands. False when one cannot be placed.
  bool settle();
  /// Whether no instance overlaps a blocking line.
  bool isFree() { return collider_.isFree(instances_, instances_.home().position, instances_.home().position); }
  /// Hands everything back; `further` gets the instances beyond home.
  void store(std::vector<InstanceState>& further) const { instances_.store(*state_, further); }
  /// Calls the contacts that last and stores.
  void finish(std::vector<InstanceState>& further);

 private:
  enum class End : std::uint8_t {
    kReached,
    kStopped,   // by a blocking line
    kRefused,   // an instance it needs cannot be placed
    kFull,      // it needs more instances than there may be at once
  };
  struct Leg {
    Point target;
    End end = End::kReached;
    std::optional<LegHit> hit;   // the line, or the warp line, that ends it
  };
  struct Event {
    Fraction time;
    bool begins;
    std::size_t placement;
    std::uint32_t line;
  };

  Leg admit(Point target);
  void insertBehind(Leg& leg, const LegHit& met);
  bool leadsAway(const LegHit& met, Point target) const;
  Point inRange(Point target) const;
  bool allInRange(Point home) const;
  Point follow(const Leg& leg);
  std::optional<Point> nudge(const LegHit& hit, Point target, Point reached);
  bool grazes(const LegHit& hit, Point target, Point reached) const;
  bool leadsOn(const LegHit& hit, Point from, Point to);
  bool leadsBack(Point left) const;
  Point slide(const LegHit& hit, Point left) const;
  Point outOf(const LegHit& hit, Point slid) const;
  Point stopBefore(const LegHit& hit, Point displacement);
  std::optional<Point> firstFree(Point candidate, Point outwards, Point displacement);
  Point normalOf(const LegHit& hit) const;
  Point homeNormalOf(const LegHit& hit) const;
  void passHome(Point& rest);

  void moveTo(Point position);
  Point position() const { return instances_.home().position; }
  void observe();

  bool tryTurn(std::int32_t hundredths);
  void turnAsFarAsFree(std::int32_t hundredths);
  void turnBy(std::int32_t hundredths);
  LineRef refOf(const Collider::Pierced& pierced) const;
  std::optional<LineRef> turnBlocker(std::int32_t hundredths);
  bool admitTurn(std::int32_t hundredths);

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
  Point wanted_;                           // the whole displacement, in the frame of the present home
  Instances instances_;
  Collider collider_;
  std::vector<Collider::Gate> shut_;       // warps that nothing could be inserted behind, for the present leg
  std::vector<Point> stops_;               // normals of what has stopped the entity where it stands, in home's frame
  std::vector<Event> events_;
  std::vector<InstanceView> views_;
};

}  // namespace platon
