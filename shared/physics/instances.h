#pragma once

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
#include "shared/physics/placement.h"
#include "shared/physics/shape_cache.h"

namespace platon {

class Collider;

/// The home and further instances of one entity, a tree that hangs together by warps. Home comes first.
class Instances {
 public:
  /// More than any shape between posts can reach; a displacement over more faces is walked in several legs.
  static constexpr std::size_t kMax = 24;
  /// Warps between home and any instance. Where only the rounded ends of the warp lines are known, every link of a
  /// chain can be off by 0.7 subunits; I5 allows 4 in all.
  static constexpr int kMaxDepth = 4;
  /// An instance is never placed farther than this from where the true isometry puts it (I5 allows 4): one more
  /// rounding comes on top while it moves.
  static constexpr std::int32_t kMaxError = 3;

  /// Shapes come from `shapes` and must outlive the instances. Costs little when nothing has changed since they were
  /// stored.
  void load(const Geometry& geometry, ShapeCache& shapes, const Convex& base, const EntityState& state,
            std::span<const InstanceState> further);
  /// Writes what concerns home back.
  void storeHome(EntityState& state) const;
  /// Writes everything back; `further` gets the instances beyond home.
  void store(EntityState& state, std::vector<InstanceState>& further) const;

  std::vector<Placement>& all() { return placements_; }
  const std::vector<Placement>& all() const { return placements_; }
  Placement& home() { return placements_.front(); }
  const Placement& home() const { return placements_.front(); }
  void appendViews(std::vector<InstanceView>& out) const;
  /// Where placement `index` is when home is at `home`: nothing is turned for where home is now.
  Point at(std::size_t index, Point home) const {
    return home == this->home().position ? placements_[index].position : placements_[index].at(home);
  }

  /// Whether the instance behind this warp of placement `index` exists.
  bool linked(std::size_t index, std::uint16_t warp) const;
  /// Whether no instance may be added behind placement `parent`.
  bool fullBehind(std::size_t parent) const;
  /// Adds the instance behind a warp of placement `parent`, at the free lattice point nearest to the true placement.
  /// False when the warp has no way back, the shape degenerates, or no point within kMaxError is free.
  bool insert(std::size_t parent, std::uint16_t warp, Collider& collider);

  /// Moves all instances along with home.
  void moveHomeTo(Point position);
  /// Turns all instances on the spot.
  void turn(std::int32_t centidegrees);
  /// The shape of placement `index` if it were turned further; null when it degenerates.
  const Convex* shapeTurned(std::size_t index, std::int32_t centidegrees);
  /// The hull of that and of its present shape; null when it degenerates.
  const Convex* hullOfTurn(std::size_t index, std::int32_t centidegrees);

  /// Whether the centre has crossed into the part of another instance.
  bool homeIsDue() const { return nextHome() != Placement::kNone; }
  /// Moves every instance that has drifted by roundings back to the free lattice point nearest to its true placement;
  /// home stays. True when any moved.
  bool mendDrift(Collider& collider);
  /// Hands home to the instance whose part the centre has crossed into. No instance moves. Returns the turn from the
  /// old home's frame to the new one's; nothing when home is not due, or when an instance would then be farther than
  /// kMaxError from its true placement.
  /// `remainder`, which belongs to home's position, becomes that of the new home's: its exact place is kept.
  std::optional<Angle> passHome(PrecisePoint& remainder);
  /// Removes the instances whose warp line their parent, grown by `margin`, no longer reaches. True when any was.
  bool dropUnreached(std::int32_t margin, Collider& collider);

 private:
  bool isAsStored(const EntityState& state, std::span<const InstanceState> further) const;
  InstanceState stateOf(const Placement& placement) const;
  void loadHome(const EntityState& state);
  void loadFurther(const InstanceState& instance);
  void turnFrames(Placement& placement) const;
  void linkParent(std::size_t index, std::uint16_t parentId);
  std::size_t nextHome() const;
  std::size_t childAbove(std::size_t index) const;
  bool isBeyond(std::size_t index) const;
  bool holdsCentre(std::size_t index) const;
  void rehome(std::size_t nextHome);
  void anchorAll();
  bool withinError(std::size_t index) const;
  bool reached(std::size_t index, std::int32_t margin, Collider& collider) const;
  bool hangs(std::size_t index) const;
  PrecisePoint ideal(std::size_t index) const;
  static PrecisePoint through(const Warp& warp, PrecisePoint point);
  static std::int64_t squaredMiss(PrecisePoint ideal, Point point);
  static std::optional<Point> nearestFree(const Placement& placement, const Point* from, PrecisePoint ideal,
                                          std::int64_t closerThan, Collider& collider);
  std::size_t unusedRegion() const;
  Point centreOf(const Placement& placement) const { return placement.position + placement.shape->centre(); }

  const Geometry* geometry_ = nullptr;
  ShapeCache* shapes_ = nullptr;
  const Convex* base_ = nullptr;
  std::uint32_t shapeIndex_ = 0;
  std::uint16_t nextId_ = 0;
  std::uint32_t crossings_ = 0;
  bool hasPassedHome_ = false;  // since they were loaded
  std::vector<Placement> placements_;
  // Room for work, kept so that a warmed-up step allocates nothing.
  std::vector<Placement> undo_;
  std::vector<std::uint8_t> kept_;
};

}  // namespace platon
