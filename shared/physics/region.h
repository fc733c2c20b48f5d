#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "platon/physics/convex.h"
#include "platon/physics/map_geometry.h"
#include "platon/physics/obstacle.h"
#include "platon/physics/segment.h"
#include "platon/physics/sweep.h"
#include "shared/physics/ideal_geometry.h"

namespace platon {

/// A cache of the segments near one instance and of their obstacles. Derived state; influences speed only. Without it,
/// the grid would be queried before each leg, and a step of 64 entities among 100 or 10 000 segments would take more
/// than 1.5 times as long.
///
/// Most segments of a crowded region stay separated from the shape by one half plane, which is all that is kept of
/// their obstacles. So its memory is 40 bytes a segment and that of at most kMaxObstacles obstacles.
class Region {
  // An obstacle, and what was derived of it.
  struct Kept {
    Obstacle obstacle;
    ObstacleEdge touched{};  // the result of the last edgeOf; its normal is (0, 0) before
  };

 public:
  /// A region with more segments covers hardly more than it must.
  static constexpr std::size_t kManySegments = 512;
  /// Limit of obstacles kept at a time.
  static constexpr std::size_t kMaxObstacles = 48;

  /// What the regions of a world share: the obstacles of all, and work space for refilling one, which would be as large
  /// as a region.
  struct Work {
    std::vector<Kept> kept;
    std::vector<std::uint32_t> unused;  ///< indices of obstacles that no region has
    std::vector<std::uint32_t> found;
    std::vector<std::uint32_t> segments;
    std::vector<std::uint32_t> obstacles;
    std::vector<Obstacle::HalfPlane> separating;
  };

  /// Ensures that the region contains every segment that touches `box`. The covered area is larger than `box`, so that
  /// an entity stays inside it for several steps. Returns whether the entries have changed. `work` must be the same in
  /// all calls, and outlive the region's use.
  bool cover(const MapGeometry& part, const Box& box, Work& work) {
    const bool isCovered = part_ == &part && covered_.contains(box);
    if (!isCovered) refill(part, box, work);
    return !isCovered;
  }
  /// Whether the region was last filled from this part.
  bool belongsTo(const MapGeometry& part) const { return part_ == &part; }

  /// Discards what was derived for a shape. Must be called before the memory of the shape is reused.
  void forgetShape();

  /// The segments of the region as ascending indices into the part's segments. A position in this list is an "entry".
  const std::vector<std::uint32_t>& segments() const { return segments_; }
  /// The first entry that belongs to a warp; the number of entries when there is none.
  std::size_t firstWarp() const { return firstWarp_; }
  /// The entry of a segment; nothing when the segment is not in the region.
  std::optional<std::size_t> entryOf(std::uint32_t segment) const;
  /// Clips the displacement of `sweep`, whose shape is `shape`, against the segment at `entry`. The shape must outlive
  /// the region's use.
  std::optional<Sweep::ClipInterval> clip(const Sweep& sweep, std::size_t entry, const Convex& shape) {
    if (sweep.misses(bounds_[entry])) return std::nullopt;
    if (shape_ == &shape && sweep.isExcluded(separating_[entry])) return std::nullopt;
    return clipClosely(sweep, entry, shape);
  }
  /// Whether the bounding box of a segment overlaps `box`.
  bool mayOverlap(const Box& box) const {
    return std::any_of(bounds_.begin(), bounds_.end(), [&](const Box& bounds) { return bounds.overlaps(box); });
  }
  /// Whether the displacement of `sweep`, whose shape is `shape`, may overlap the segment at `entry`. Never false when
  /// it does.
  bool mayOverlap(const Sweep& sweep, std::size_t entry, const Convex& shape) {
    if (sweep.misses(bounds_[entry])) return false;
    if (shape_ != &shape || obstacleOf_[entry] == kNoObstacle) return clipClosely(sweep, entry, shape).has_value();
    return !sweep.isExcluded(separating_[entry]);
  }
  /// Clips the ideal path of `shape` against the segment at `entry`, where `mayOverlap` was true for `sweep`. The path
  /// must be within the margin of `sweep` of its displacement.
  std::optional<IdealEntry> clipIdeal(const Sweep& sweep, std::size_t entry, PrecisePoint from,
                                      PrecisePoint displacement);
  /// Whether the ideal path of the shape of the last sweep enters the obstacle at `entry` at its start.
  bool entersAtOnce(std::size_t entry, PrecisePoint from, PrecisePoint displacement);
  /// The edge of the obstacle at `entry` that a path of `shape` enters at once because it starts on it, far from all
  /// others; the result of `clipIdeal` is the same. Nothing in other cases, or if the obstacle is not known.
  std::optional<std::size_t> touchedEdge(std::size_t entry, const Convex& shape, PrecisePoint from,
                                         PrecisePoint displacement);
  /// The edge on the half plane of that number of the obstacle at `entry`.
  ObstacleEdge edgeOf(std::size_t entry, std::size_t index);
  /// The collision that belongs to the result of `clip`.
  Hit hitOf(std::size_t entry, const Sweep::ClipInterval& interval) const {
    if (hasObstacle(entry)) return Sweep::hitOf(keptAt(entry).obstacle, interval);
    return Sweep::hitOf(*shape_, part_->segments[segments_[entry]], interval);
  }

 private:
  static constexpr std::uint32_t kNoObstacle = ~std::uint32_t{0};
  // Excludes nothing.
  static constexpr Obstacle::HalfPlane kNoHalfPlane{{}, -1};

  void refill(const MapGeometry& part, const Box& box, Work& work);
  void keepDerived(Work& work);
  void keepSeparation(const Sweep& sweep, std::size_t entry, const Obstacle& obstacle);
  std::optional<Sweep::ClipInterval> clipClosely(const Sweep& sweep, std::size_t entry, const Convex& shape);
  bool hasObstacle(std::size_t entry) const {
    return obstacleOf_[entry] != kNoObstacle && keptAt(entry).obstacle.belongsTo(*shape_);
  }
  Kept& keptAt(std::size_t entry) const { return work_->kept[obstacleOf_[entry]]; }
  bool isSeparated(std::size_t entry) const { return separating_[entry].normal != Point(); }
  void allocateObstacle(std::size_t entry);
  Obstacle& obstacle(std::size_t entry, const Convex& shape) {
    Kept& kept = keptAt(entry);
    if (!kept.obstacle.belongsTo(shape)) {
      kept.obstacle.build(shape, part_->segments[segments_[entry]]);
      kept.touched = {};
    }
    return kept.obstacle;
  }

  const MapGeometry* part_ = nullptr;
  const Convex* shape_ = nullptr;  // that of separating_
  Box covered_;
  std::vector<std::uint32_t> segments_;
  std::size_t firstWarp_ = 0;
  std::vector<Box> bounds_;                      // by entry
  std::vector<Obstacle::HalfPlane> separating_;  // by entry: one that excluded a displacement, or kNoHalfPlane
  std::vector<std::uint32_t> obstacleOf_;        // by entry: index into work_->kept, or kNoObstacle
  std::size_t obstacleCount_ = 0;
  Work* work_ = nullptr;
};

}  // namespace platon
