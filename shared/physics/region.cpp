#include "shared/physics/region.h"

#include <algorithm>
#include <limits>

#include "platon/exact/integer.h"

namespace platon {
namespace {

// Segments are within the coordinate limit, so a region never extends beyond it.
std::int32_t clamped(std::int64_t coordinate) {
  return static_cast<std::int32_t>(std::clamp<std::int64_t>(coordinate, -kCoordinateLimit, kCoordinateLimit));
}

Box clamped(const Box& box) {
  return {{clamped(box.low.x), clamped(box.low.y)}, {clamped(box.high.x), clamped(box.high.y)}};
}

// Adds half the size of the box on every side: an entity at constant speed then refills its region every few steps
// only.
Box widened(const Box& box) {
  const std::int64_t marginX = (std::int64_t{box.high.x} - box.low.x) / 2;
  const std::int64_t marginY = (std::int64_t{box.high.y} - box.low.y) / 2;
  return {{clamped(box.low.x - marginX), clamped(box.low.y - marginY)},
          {clamped(box.high.x + marginX), clamped(box.high.y + marginY)}};
}

// A box that extends to the coordinate limit covers everything beyond it.
Box unbounded(Box box) {
  using Limits = std::numeric_limits<std::int32_t>;
  if (box.low.x == -kCoordinateLimit) box.low.x = Limits::min();
  if (box.low.y == -kCoordinateLimit) box.low.y = Limits::min();
  if (box.high.x == kCoordinateLimit) box.high.x = Limits::max();
  if (box.high.y == kCoordinateLimit) box.high.y = Limits::max();
  return box;
}

}  // namespace

// Warp segments are selected by their bounding boxes, not by the grid: the corner of a shape with a margin extends
// beyond the bounds of the sweep, so a segment that the grid excludes may still be hit.
void Region::refill(const MapGeometry& part, const Box& box) {
  const bool isSamePart = part_ == &part;
  part_ = &part;
  const Box wide = widened(clamped(box));
  covered_ = unbounded(wide);
  previousSegments_ = segments_;  // not swapped: both vectors keep their capacity
  segments_.clear();
  part.grid.query(wide, segments_);
  std::erase_if(segments_, [&](std::uint32_t segment) {
    return part.isWarp(segment) || !wide.overlaps(boundsOf(part.segments[segment]));
  });
  firstWarp_ = segments_.size();
  for (std::uint32_t segment = part.segmentOfWarp(0); segment < part.segments.size(); ++segment) {
    if (wide.overlaps(boundsOf(part.segments[segment]))) segments_.push_back(segment);
  }
  bounds_.clear();
  for (const std::uint32_t segment : segments_) bounds_.push_back(boundsOf(part.segments[segment]));
  previousObstacles_ = obstacleOf_;
  obstacleOf_.assign(segments_.size(), kNoObstacle);
  if (!isSamePart) previousSegments_.assign(previousSegments_.size(), kNoObstacle);
  keepObstacles();
}

// Reassigns the obstacles of segments that are still in the region; the others become unused.
void Region::keepObstacles() {
  auto segment = segments_.begin();
  for (std::size_t before = 0; before < previousSegments_.size(); ++before) {
    if (previousObstacles_[before] == kNoObstacle) continue;
    segment = std::lower_bound(segment, segments_.end(), previousSegments_[before]);
    if (segment != segments_.end() && *segment == previousSegments_[before]) {
      obstacleOf_[static_cast<std::size_t>(segment - segments_.begin())] = previousObstacles_[before];
    } else {
      unused_.push_back(previousObstacles_[before]);
    }
  }
}

void Region::allocateObstacle(std::size_t entry) {
  if (unused_.empty()) {
    obstacleOf_[entry] = static_cast<std::uint32_t>(obstacles_.size());
    obstacles_.emplace_back();
    return;
  }
  obstacleOf_[entry] = unused_.back();
  unused_.pop_back();
  obstacles_[obstacleOf_[entry]].reset();
}

std::optional<std::size_t> Region::entryOf(std::uint32_t segment) const {
  const auto found = std::lower_bound(segments_.begin(), segments_.end(), segment);
  if (found == segments_.end() || *found != segment) return std::nullopt;
  return static_cast<std::size_t>(found - segments_.begin());
}

}  // namespace platon
