#include "shared/physics/region.h"

#include <algorithm>
#include <limits>

#include "platon/exact/integer.h"
#include "shared/physics/tolerances.h"

namespace platon {
namespace {

// Segments are within the coordinate limit, so a region never extends beyond it.
std::int32_t clamped(std::int64_t coordinate) {
  return static_cast<std::int32_t>(std::clamp<std::int64_t>(coordinate, -kCoordinateLimit, kCoordinateLimit));
}

Box clamped(const Box& box) {
  return {{clamped(box.low.x), clamped(box.low.y)}, {clamped(box.high.x), clamped(box.high.y)}};
}

// Adds a part of the size of the box on every side. With a half, an entity at constant speed refills its region every
// few steps only.
Box widened(const Box& box, std::int64_t divisor) {
  const std::int64_t marginX = (std::int64_t{box.high.x} - box.low.x) / divisor;
  const std::int64_t marginY = (std::int64_t{box.high.y} - box.low.y) / divisor;
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
void Region::refill(const MapGeometry& part, const Box& box, Work& work) {
  const bool isSamePart = part_ == &part;
  part_ = &part;
  work_ = &work;
  Box wide = widened(clamped(box), 2);
  std::vector<std::uint32_t>& found = work.found;
  found.clear();
  part.grid.query(wide, part.segments, found);
  if (found.size() > kManySegments) {
    wide = widened(clamped(box), 8);
    std::erase_if(found, [&](std::uint32_t segment) { return !touches(part.segments[segment], wide); });
  }
  covered_ = unbounded(wide);
  std::erase_if(found, [&](std::uint32_t segment) { return part.isWarp(segment); });
  firstWarp_ = found.size();
  for (std::uint32_t segment = part.segmentOfWarp(0); segment < part.segments.size(); ++segment) {
    if (wide.overlaps(boundsOf(part.segments[segment]))) found.push_back(segment);
  }
  work.segments.assign(segments_.begin(), segments_.end());
  segments_.assign(found.begin(), found.end());  // allocates no more than is needed
  bounds_.clear();
  bounds_.reserve(found.size());
  for (const std::uint32_t segment : found) bounds_.push_back(boundsOf(part.segments[segment]));
  if (!isSamePart) work.segments.assign(work.segments.size(), kNoObstacle);
  keepDerived(work);
}

void Region::forgetShape() {
  shape_ = nullptr;
  for (std::size_t entry = 0; entry < obstacleOf_.size(); ++entry) {
    if (obstacleOf_[entry] != kNoObstacle) keptAt(entry).obstacle.reset();
  }
}

// Keeps what is known of segments that are still in the region. The obstacles of the others become unused, and, when
// the region may have no more, those from which the shape is separated.
void Region::keepDerived(Work& work) {
  const bool isFull = obstacleCount_ == kMaxObstacles;
  work.obstacles = obstacleOf_;
  work.separating = separating_;
  obstacleOf_.assign(segments_.size(), kNoObstacle);
  separating_.assign(segments_.size(), kNoHalfPlane);
  auto segment = segments_.begin();
  for (std::size_t before = 0; before < work.segments.size(); ++before) {
    segment = std::lower_bound(segment, segments_.end(), work.segments[before]);
    const bool isKept = segment != segments_.end() && *segment == work.segments[before];
    const auto entry = static_cast<std::size_t>(segment - segments_.begin());
    if (isKept) separating_[entry] = work.separating[before];
    if (work.obstacles[before] == kNoObstacle) continue;
    if (isKept && !(isFull && isSeparated(entry))) {
      obstacleOf_[entry] = work.obstacles[before];
    } else {
      work.unused.push_back(work.obstacles[before]);
      --obstacleCount_;
    }
  }
}

// Only segments from which no half plane separates the shape get an obstacle.
std::optional<Sweep::ClipInterval> Region::clipClosely(const Sweep& sweep, std::size_t entry, const Convex& shape) {
  if (shape_ != &shape) separating_.assign(separating_.size(), kNoHalfPlane);
  shape_ = &shape;
  if (obstacleOf_[entry] == kNoObstacle) {
    separating_[entry] = kNoHalfPlane;
    const auto interval = sweep.clip(part_->segments[segments_[entry]], separating_[entry]);
    if (!isSeparated(entry) && obstacleCount_ < kMaxObstacles) allocateObstacle(entry);
    return interval;
  }
  Obstacle& obstacle = this->obstacle(entry, shape);
  const auto interval = sweep.clip(obstacle);
  if (!interval) keepSeparation(sweep, entry, obstacle);
  return interval;
}

void Region::keepSeparation(const Sweep& sweep, std::size_t entry, const Obstacle& obstacle) {
  if (sweep.isExcluded(obstacle.separatingHalfPlane())) separating_[entry] = obstacle.separatingHalfPlane();
}

std::optional<IdealEntry> Region::clipIdeal(const Sweep& sweep, std::size_t entry, PrecisePoint from,
                                            PrecisePoint displacement) {
  if (obstacleOf_[entry] == kNoObstacle)
    return platon::clipIdeal(*shape_, part_->segments[segments_[entry]], from, displacement);
  Obstacle& obstacle = this->obstacle(entry, *shape_);
  const auto entered = platon::clipIdeal(obstacle, sweep.path().grown(Tolerances::kNear), from, displacement);
  if (!entered) keepSeparation(sweep, entry, obstacle);
  return entered;
}

std::optional<std::size_t> Region::touchedEdge(std::size_t entry, const Convex& shape, PrecisePoint from,
                                               PrecisePoint displacement) {
  if (shape_ != &shape || !hasObstacle(entry)) return std::nullopt;
  const Point place = rounded(from);
  return platon::touchedEdge(keptAt(entry).obstacle, Box{place, place}.grown(1), from, displacement);
}

bool Region::entersAtOnce(std::size_t entry, PrecisePoint from, PrecisePoint displacement) {
  const Box positions = Box{rounded(from), rounded(from)}.swept(rounded(displacement)).grown(2);
  const auto entered = obstacleOf_[entry] == kNoObstacle
                           ? platon::clipIdeal(*shape_, part_->segments[segments_[entry]], from, displacement)
                           : platon::clipIdeal(obstacle(entry, *shape_), positions, from, displacement);
  return entered && entered->time.numerator == 0;
}

ObstacleEdge Region::edgeOf(std::size_t entry, std::size_t index) {
  const Segment& segment = part_->segments[segments_[entry]];
  if (!hasObstacle(entry)) return platon::edgeOf(*shape_, segment, halfPlaneOf(*shape_, segment, index));
  const Obstacle::HalfPlane half = keptAt(entry).obstacle.halfPlane(index);
  ObstacleEdge& edge = keptAt(entry).touched;
  if (edge.half.normal != half.normal) edge = platon::edgeOf(*shape_, segment, half);
  return edge;
}

void Region::allocateObstacle(std::size_t entry) {
  ++obstacleCount_;
  if (work_->unused.empty()) {
    std::vector<Kept>& kept = work_->kept;
    obstacleOf_[entry] = static_cast<std::uint32_t>(kept.size());
    if (kept.size() == kept.capacity())
      kept.reserve(kept.size() + kept.size() / 8 + 8);  // doubled, most would be unused
    kept.emplace_back();
    return;
  }
  obstacleOf_[entry] = work_->unused.back();
  work_->unused.pop_back();
  keptAt(entry).obstacle.reset();
}

std::optional<std::size_t> Region::entryOf(std::uint32_t segment) const {
  const auto found = std::lower_bound(segments_.begin(), segments_.end(), segment);
  if (found == segments_.end() || *found != segment) return std::nullopt;
  return static_cast<std::size_t>(found - segments_.begin());
}

}  // namespace platon
