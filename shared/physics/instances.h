#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "platon/exact/angle.h"
#include "platon/exact/point.h"
#include "platon/exact/precise_point.h"
#include "platon/physics/convex.h"
#include "platon/physics/entity_state.h"
#include "platon/physics/map_geometry.h"
#include "platon/physics/step_observer.h"
#include "shared/physics/shape_cache.h"

namespace platon {

class Collider;

/// The working copy of one instance of an entity during a step. See InstanceState for the anchors.
struct Placement {
  static constexpr std::size_t kNone = ~std::size_t{0};

  const MapGeometry* part = nullptr;
  const Convex* shape = nullptr;  ///< the entity's shape rotated by `angle`
  Angle angle;
  Rotation fromHome;  ///< from the frame of the home part to the frame of this part
  Rotation toHome;    ///< from the frame of this part to the frame of the home part
  Point position;
  Point homeAnchor;
  Point anchor;
  std::size_t parent = kNone;     ///< index among the placements; kNone when there is no parent
  std::uint16_t warp = 0;         ///< index, in the parent's part, of the warp to this part
  std::uint16_t reverseWarp = 0;  ///< index, in this part, of the warp to the parent's part
  std::uint16_t id = 0;
  bool fresh = false;      ///< see InstanceState; in a step, also of what it has inserted
  std::size_t region = 0;  ///< index among the entity's regions

  /// The position of this instance when the home instance is at `home`. Bounds: cosine and sine together are at most
  /// 1.5 * 2^30, so a rotated difference is below 1.5 * 2^30, and its sum with the anchor fits int32.
  Point at(Point home) const {
    const Point moved = home - homeAnchor;
    return anchor + (fromHome == Rotation::none() ? moved : rotate(moved, fromHome));
  }
};

/// The instances of one entity during a step: the home instance, at index 0, and the further instances. Instances that
/// were reached through a warp have a parent; these links form a tree with the home instance as root.
class Instances {
 public:
  /// Limit of instances at a time. More than any shape between posts can reach; a displacement across more faces is
  /// divided into several legs.
  static constexpr std::size_t kMax = 24;
  /// Limit of warps between the home instance and another instance. When only the rounded ends of the warp segments are
  /// known, each warp adds an error of up to 0.7 subunits, and I5 allows 4.
  static constexpr int kMaxDepth = 4;
  /// Limit of the distance between a new instance and its exact position, in subunits. One less than I5 allows, because
  /// motion adds one more rounding.
  static constexpr std::int32_t kMaxError = 3;

  /// Reads the instances from saved state. Fast when the state is the one last stored. `geometry`, `shapes` and `base`
  /// must outlive the use of the instances.
  void load(const Geometry& geometry, ShapeCache& shapes, const Convex& base, const EntityState& state,
            std::span<const InstanceState> further);
  /// Discards the instances: the next `load` reads them again. Must be called before cached shapes are cleared.
  void forget() {
    geometry_ = nullptr;
    placements_.clear();
  }
  /// Writes the state of the home instance.
  void storeHome(EntityState& state) const;
  /// Writes the state of all instances; appends the further instances to `further`.
  void store(EntityState& state, std::vector<InstanceState>& further) const;

  std::vector<Placement>& all() { return placements_; }
  const std::vector<Placement>& all() const { return placements_; }
  Placement& home() { return placements_.front(); }
  const Placement& home() const { return placements_.front(); }
  /// The largest Placement::region.
  std::size_t lastRegion() const {
    return isAlone() ? home().region
                     : std::max_element(placements_.begin(), placements_.end(), [](const auto& a, const auto& b) {
                         return a.region < b.region;
                       })->region;
  }
  /// Whether the home instance is the only one, which is usual.
  bool isAlone() const { return &placements_.front() == &placements_.back(); }
  void appendViews(std::vector<InstanceView>& out) const;
  /// Position of placement `index` when the home instance is at `home`. Fast for the current home position.
  Point at(std::size_t index, Point home) const {
    if (index == 0) return home;
    return home == this->home().position ? placements_[index].position : placements_[index].at(home);
  }

  /// Whether the neighbour of placement `index` across this warp exists: its parent or one of its children.
  bool hasInstanceBehind(std::size_t index, std::uint16_t warp) const;
  /// Whether kMax or kMaxDepth forbids another child of placement `parent`.
  bool isAtInstanceLimit(std::size_t parent) const;
  /// Adds a child of placement `parent` across a warp, at the free lattice point nearest to its exact position. Returns
  /// false when the warp has no reverse warp, the rotated shape is degenerate, or no point within kMaxError is free.
  bool insert(std::size_t parent, std::uint16_t warp, Collider& collider);

  /// The ideal place of placement `index` when that of the home instance is `home`: taken through the warps.
  PrecisePoint idealOf(std::size_t index, PrecisePoint home) const {
    return index == 0 ? home : idealOfFurther(index, home);
  }

  /// Moves the home instance to `position` and all others with it.
  void moveHomeTo(Point position);
  /// Rotates all instances about their positions.
  void rotateShapes(std::int32_t centidegrees);
  /// The shape of placement `index` rotated by further `centidegrees`. Null when it is degenerate.
  const Convex* rotatedShape(std::size_t index, std::int32_t centidegrees);
  /// The bounding box of rotationHull at the position of the placement. Nothing when rotatedShape is degenerate.
  std::optional<Box> rotationBounds(std::size_t index, std::int32_t centidegrees);
  /// The convex hull of the current shape of placement `index` and of rotatedShape. Null when it is degenerate.
  const Convex* rotationHull(std::size_t index, std::int32_t centidegrees);

  /// Whether the home instance can be at `home` with the centre of the shape in the home part, perhaps after some
  /// rehomes.
  bool mayBeAt(Point home, Collider& collider) {
    return isAlone() || containsCentreAt(home) || canRehomeAt(home, collider);
  }
  /// Makes the instance into whose part the centre has crossed the home instance. Before it corrects drift: moves every
  /// further instance whose rounding error has grown to the free lattice point nearest to its exact position, and calls
  /// onDrift if any has moved. Returns the rotation from the old home frame to the new one. Returns nothing when no
  /// rehome is needed or when an instance would be farther than kMaxError from its exact position. Converts
  /// `remainder`, which belongs to the home position, so that position plus remainder stay the same point.
  template <class OnDrift>
  std::optional<Angle> rehome(PrecisePoint& remainder, Collider& collider, OnDrift&& onDrift) {
    if (isAlone()) return std::nullopt;
    std::size_t next = nextHome();
    if (next != Placement::kNone && correctDrift(collider)) {
      onDrift();
      next = nextHome();
    }
    return next == Placement::kNone ? std::nullopt : rehomeTo(next, remainder);
  }
  /// Gives the ids from `first` on again if all instances that have got one are removed: so what a body inserts and
  /// removes in each tick does not change its state. Requires that the others are not fresh.
  void reuseIds(std::uint16_t first);
  /// Removes the instances whose parent, with `margin`, no longer reaches the warp segment. Returns whether any was
  /// removed.
  bool dropUnreached(std::int32_t margin, Collider& collider) { return !isAlone() && dropOthers(margin, collider); }

 private:
  bool matches(const EntityState& state, std::span<const InstanceState> further) const;
  InstanceState stateOf(const Placement& placement) const;
  void loadHome(const EntityState& state);
  void loadFurther(const InstanceState& instance);
  void updateRotations(Placement& placement) const;
  void linkParent(std::size_t index, std::uint16_t parentId);
  std::size_t nextHome() const;
  std::size_t childOfHome(std::size_t index) const;
  bool isBeyondWarp(std::size_t index) const;
  bool containsCentre(std::size_t index) const {
    return isInside(*placements_[index].part, centreOf(placements_[index]));
  }
  bool containsCentreAt(Point position) const { return isInside(*home().part, position + home().shape->centre()); }
  static bool isInside(const MapGeometry& part, Point centre);
  bool canRehomeAt(Point home, Collider& collider);
  bool correctDrift(Collider& collider);
  std::optional<Angle> rehomeTo(std::size_t next, PrecisePoint& remainder);
  void makeHome(std::size_t nextHome);
  bool dropOthers(std::int32_t margin, Collider& collider);
  void anchorAll();
  bool isWithinError(std::size_t index) const;
  bool isReached(std::size_t index, std::int32_t margin, Collider& collider) const;
  PrecisePoint exactPosition(std::size_t index) const;
  PrecisePoint idealOfFurther(std::size_t index, PrecisePoint home) const;
  static std::int64_t squaredError(PrecisePoint ideal, Point point);
  enum class Arrival : std::uint8_t { kMoves, kAppears };
  static std::optional<Point> nearestFree(Placement placement, Arrival arrival, PrecisePoint ideal,
                                          std::int64_t closerThan, Collider& collider);
  std::size_t unusedRegion() const;
  Point centreOf(const Placement& placement) const { return placement.position + placement.shape->centre(); }

  const Geometry* geometry_ = nullptr;
  ShapeCache* shapes_ = nullptr;
  const Convex* base_ = nullptr;
  std::uint32_t shapeIndex_ = 0;
  std::uint16_t nextId_ = 0;
  std::uint32_t crossings_ = 0;
  bool hasRehomed_ = false;  // since load
  std::vector<Placement> placements_;
};

}  // namespace platon
