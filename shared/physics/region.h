#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "platon/physics/convex.h"
#include "platon/physics/map_geometry.h"
#include "platon/physics/obstacle.h"
#include "platon/physics/segment.h"

namespace platon {

/// The region of the report: a cache of the segments near one instance and of their obstacles. Derived state;
/// influences speed only. Without it, the grid would be queried before each leg, and a step of 64 entities among 100 or
/// 10 000 segments would take more than 1.5 times as long.
class Region {
 public:
  /// Ensures that the region contains every segment that touches `box`. The covered area is larger than `box`, so that
  /// an entity stays inside it for several steps.
  void cover(const MapGeometry& part, const Box& box) {
    if (part_ != &part || !covered_.contains(box)) refill(part, box);
  }
  /// Whether the region was last filled from this part.
  bool belongsTo(const MapGeometry& part) const { return part_ == &part; }

  /// The segments of the region as ascending indices into the part's segments. A position in this list is an "entry".
  const std::vector<std::uint32_t>& segments() const { return segments_; }
  /// The first entry that belongs to a warp; the number of entries when there is none.
  std::size_t firstWarp() const { return firstWarp_; }
  /// The entry of a segment; nothing when the segment is not in the region.
  std::optional<std::size_t> entryOf(std::uint32_t segment) const;
  /// Bounding box of the segment at `entry`.
  const Box& bounds(std::size_t entry) const { return bounds_[entry]; }
  /// The obstacle of the segment at `entry` for `shape`, which must outlive the region's use.
  Obstacle& obstacle(std::size_t entry, const Convex& shape) {
    if (obstacleOf_[entry] == kNoObstacle) allocateObstacle(entry);
    Obstacle& obstacle = obstacles_[obstacleOf_[entry]];
    if (!obstacle.belongsTo(shape)) obstacle.build(shape, part_->segments[segments_[entry]]);
    return obstacle;
  }

 private:
  static constexpr std::uint32_t kNoObstacle = ~std::uint32_t{0};

  void refill(const MapGeometry& part, const Box& box);
  void keepObstacles();
  void allocateObstacle(std::size_t entry);

  const MapGeometry* part_ = nullptr;
  Box covered_;
  std::vector<std::uint32_t> segments_;
  std::size_t firstWarp_ = 0;
  std::vector<Box> bounds_;                // by entry
  std::vector<std::uint32_t> obstacleOf_;  // by entry: index into obstacles_, or kNoObstacle before the first query
  std::vector<Obstacle> obstacles_;
  std::vector<std::uint32_t> unused_;            // indices of obstacles whose segments left the region
  std::vector<std::uint32_t> previousSegments_;  // work space of refill
  std::vector<std::uint32_t> previousObstacles_;
};

}  // namespace platon
