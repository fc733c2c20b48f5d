#include "shared/physics/collider.h"

#include <algorithm>
#include <utility>

#include "shared/physics/ideal_geometry.h"
#include "shared/physics/tolerances.h"
#include "shared/physics/turned_normal.h"

namespace platon {
namespace {

// An ideal place farther from the position of its instance, along an axis, is not compared with segments: the ends of a
// path are rounded to less than a subunit.
constexpr std::int64_t kMaxRemainder = (Tolerances::kNear - 1) * PrecisePoint::kOne;

}  // namespace

Point normalOf(const Instances& instances, const LegHit& hit) {
  if (hit.hit.side != Hit::Side::kInside) return hit.hit.normal;
  const Segment& segment = segmentOf(instances, hit);
  return perpendicular(segment.b - segment.a);
}

Point homeNormalOf(const Instances& instances, const LegHit& hit) {
  const Point normal = normalOf(instances, hit);
  return hit.placement == 0 ? normal : turnedNormal(normal, placementOf(instances, hit).toHome);
}

bool Collider::contains(const std::vector<SegmentRef>& refs, const SegmentRef& ref) {
  return std::any_of(refs.begin(), refs.end(), [&](const SegmentRef& other) { return isSame(other, ref); });
}

// The angle between two instances of one shape is that between their frames.
SegmentRef Collider::refOf(const Placement& placement, std::uint32_t segment) const {
  const MapGeometry& part = *placement.part;
  return {.part = part.id,
          .index = segment,
          .warp = part.isWarp(segment),
          .ends = part.segments[segment],
          .instance = placement.id,
          .toHome = angle_ - placement.angle,
          .position = placement.position,
          .tag = part.tagOf(segment)};
}

void Collider::begin(Rules& rules, Entity entity, const Instances& instances, std::vector<Region>& regions,
                     Region::Work& work) {
  rules_ = &rules;
  scope_ = rules.scope();
  entity_.emplace(entity);
  angle_ = instances.home().angle;
  regions_ = &regions;
  work_ = &work;
  provideRegion(instances.lastRegion());
  pierced_.clear();
  knowsNear_ = false;
  overlapped_.clear();
  asksRules_ = false;
  solid_.clear();
}

Region& Collider::start(const Placement& placement, const Convex& shape, Point from, Point to) {
  sweep_.start(shape, from, to - from);
  return coveringRegion(placement, sweep_.bounds());
}

// The region of the placement, which covers `box` with kRegionMargin. Entries noted before are void if it is refilled.
Region& Collider::coveringRegion(const Placement& placement, const Box& box) {
  Region& region = regionOf(placement);
  if (region.cover(*placement.part, box.grown(kRegionMargin), *work_)) knowsNear_ = false;
  return region;
}

// Clips the path of sweep_, which must have been started with the placement's shape, against the segment at `entry`.
std::optional<Sweep::ClipInterval> Collider::clip(const Placement& placement, Region& region, std::size_t entry) {
  return region.clip(sweep_, entry, *placement.shape);
}

bool Collider::blocks(const Placement& placement, std::uint32_t segment) {
  if (scope_ != Rules::Scope::kEverything && placement.part->isWarp(segment)) return false;
  if (scope_ == Rules::Scope::kContacts) return true;
  if (scope_ == Rules::Scope::kSegments && !rules_->mayPierce(placement.part->id, segment)) {
    solid_.push_back({placement.part->id, segment});
    return overlapped_.empty() || !contains(overlapped_, refOf(placement, segment));
  }
  asksRules_ = true;
  const SegmentRef ref = refOf(placement, segment);
  return !contains(overlapped_, ref) && !rules_->pierce(*entity_, ref);
}

void Collider::record(const SegmentRef& ref) {
  if (!contains(pierced_, ref)) pierced_.push_back(ref);
}

bool Collider::blocksOrRecord(const Placement& placement, std::uint32_t segment) {
  if (blocks(placement, segment)) return true;
  record(refOf(placement, segment));
  return false;
}

std::optional<LegHit> Collider::first(const Instances& instances, Point from, Point to) {
  std::optional<LegHit> best;
  for (std::size_t i = 0; i < instances.all().size(); ++i) first(instances, i, from, to, best);
  return best;
}

void Collider::first(const Instances& instances, std::size_t index, Point from, Point to, std::optional<LegHit>& best) {
  if (isFinal(best)) return;
  const Placement& placement = instances.all()[index];
  Region& region = start(placement, *placement.shape, instances.at(index, from), placement.at(to));
  for (std::size_t entry = 0; entry < checkedEntries(region) && !isFinal(best); ++entry) {
    const std::uint32_t segment = region.segments()[entry];
    const auto interval = clip(placement, region, entry);
    if (!interval || !blocksOrRecord(placement, segment) || (best && interval->enter >= best->hit.time)) continue;
    best = LegHit{index, segment, region.hitOf(entry, *interval)};
  }
}

void Collider::startLeg(const Instances& instances, Point to) {
  leg_ = {instances.home().position, to};
  near_.clear();
  knowsNear_ = true;
}

void Collider::firstIdeal(const Instances& instances, std::size_t index, PrecisePoint idealFrom,
                          PrecisePoint displacement, std::optional<LegHit>& best, std::uint32_t ignored) {
  const Placement& placement = instances.all()[index];
  // So that the sweep below finds every segment that the ideal path meets, whatever is known of them already.
  if (maxNorm(idealFrom - precise(placement.position)) > kMaxRemainder) idealFrom = precise(placement.position);
  sweep_.start(*placement.shape, placement.position, instances.at(index, leg_.to) - placement.position,
               Tolerances::kNear);
  Region& region = regionOf(placement);
  region.cover(*placement.part, sweep_.bounds().grown(kRegionMargin), *work_);
  for (std::size_t entry = 0; entry < checkedEntries(region); ++entry) {
    if (isFinal(best)) {
      knowsNear_ = false;
      return;
    }
    const std::uint32_t segment = region.segments()[entry];
    if (!region.mayOverlap(sweep_, entry, *placement.shape)) continue;
    near_.push_back({index, entry});
    if (segment == ignored) continue;
    const auto entered = region.clipIdeal(sweep_, entry, idealFrom, displacement);
    if (!entered || (best && entered->time >= best->hit.time) || !blocks(placement, segment)) continue;
    best = LegHit{index, segment, region.hitOf(entry, {.enter = entered->time, .entered = entered->edge}),
                  region.edgeOf(entry, entered->edge)};
  }
}

std::optional<LegHit> Collider::touching(const Instances& instances, std::uint32_t segment, PrecisePoint ideal,
                                         PrecisePoint displacement) {
  const Placement& home = instances.home();
  Region& region = regionOf(home);
  const bool blocksAlways = scope_ == Rules::Scope::kContacts ||
                            (scope_ == Rules::Scope::kSegments && !rules_->mayPierce(home.part->id, segment));
  if (!region.belongsTo(*home.part) || !blocksAlways || !blocks(home, segment)) return std::nullopt;
  const std::optional<std::size_t> entry = region.entryOf(segment);
  if (!entry) return std::nullopt;
  const auto edge = region.touchedEdge(*entry, *home.shape, ideal, displacement);
  if (!edge) return std::nullopt;
  return LegHit{0, segment, region.hitOf(*entry, {.entered = *edge}), region.edgeOf(*entry, *edge)};
}

bool Collider::entersEarlier(const Instances& instances, std::uint32_t segment, PrecisePoint ideal,
                             PrecisePoint displacement) {
  if (!knowsNear_) return true;
  const Placement& home = instances.home();
  Region& region = regionOf(home);
  return std::any_of(near_.begin(), near_.end(), [&](const Near& near) {
    return near.placement == 0 && region.segments()[near.entry] < segment &&
           region.entersAtOnce(near.entry, ideal, displacement) && blocks(home, region.segments()[near.entry]);
  });
}

bool Collider::isFreeInLeg(const Instances& instances, Point to) {
  if (!knowsNear_ || !isNearLeg(to)) return isFree(instances, leg_.from, to);
  for (std::size_t i = 0; i < near_.size(); ++i) {
    const Placement& placement = instances.all()[near_[i].placement];
    if (i == 0 || near_[i].placement != near_[i - 1].placement)
      sweep_.start(*placement.shape, placement.position, instances.at(near_[i].placement, to) - placement.position);
    Region& region = regionOf(placement);
    if (clip(placement, region, near_[i].entry) && blocksOrRecord(placement, region.segments()[near_[i].entry]))
      return false;
  }
  return true;
}

// Whether a straight move from the start of the leg to `place` stays so near to its path that no instance reaches other
// segments than those in near_. Bounds: differences < 2^30, so that sums of two products are < 2^61.
bool Collider::isNearLeg(Point place) const {
  // Rotated by 45° and rounded at both ends.
  static_assert(3 * Tolerances::kBeside + 2 * 2 < 2 * Tolerances::kNear);
  if (place == leg_.to) return true;
  const Point moved = place - leg_.from;
  if (maxNorm(moved) <= Tolerances::kBeside || maxNorm(place - leg_.to) <= Tolerances::kBeside) return true;
  const Point path = leg_.to - leg_.from;
  if (path == Point()) return false;
  const std::int64_t along = dot(path, moved);
  const std::int64_t beside = std::abs(cross(path, moved));  // at least the distance times maxNorm(path)
  return along >= 0 && along <= squaredLength(path) && beside <= std::int64_t{Tolerances::kBeside} * maxNorm(path);
}

bool Collider::isNearWarps(const Instances& instances) const {
  return std::any_of(instances.all().begin(), instances.all().end(), [&](const Placement& placement) {
    const Region& region = (*regions_)[placement.region];
    return region.firstWarp() != region.segments().size();
  });
}

std::optional<LegHit> Collider::firstWarp(const Instances& instances, const Path& path,
                                          const std::optional<LegHit>& limit, const std::vector<WarpRef>& refused) {
  if (limit && limit->hit.time.numerator == 0) return std::nullopt;  // nothing is earlier
  std::optional<LegHit> best;
  const LegHit* earliest = limit ? &*limit : nullptr;
  for (std::size_t i = 0; i < instances.all().size(); ++i) {
    const Placement& placement = instances.all()[i];
    const MapGeometry& part = *placement.part;
    Region& region = regionOf(placement);
    bool started = false;
    for (std::size_t entry = region.firstWarp(); entry < region.segments().size(); ++entry) {
      const std::uint32_t segment = region.segments()[entry];
      const WarpRef ref{i, static_cast<std::uint16_t>(part.warpOfSegment(segment))};
      if (instances.hasInstanceBehind(i, ref.warp) || std::find(refused.begin(), refused.end(), ref) != refused.end())
        continue;
      if (!std::exchange(started, true)) {
        const Point from = instances.at(i, path.from);
        sweep_.start(*placement.shape, from, placement.at(path.to) - from, path.margin);
      }
      const auto interval = clip(placement, region, entry);
      if (!interval || (earliest && interval->enter >= earliest->hit.time) || blocks(placement, segment)) continue;
      best = LegHit{i, segment, region.hitOf(entry, *interval)};
      earliest = &*best;
    }
  }
  return best;
}

bool Collider::reachesWarp(const Instances& instances, const WarpRef& ref, const Convex& shape, std::int32_t margin) {
  const Placement& placement = instances.all()[ref.placement];
  sweep_.start(shape, placement.position, {}, margin);
  return sweep_.against(placement.part->warps[ref.warp].from) &&
         !instances.hasInstanceBehind(ref.placement, ref.warp) &&
         !blocks(placement, placement.part->segmentOfWarp(ref.warp));
}

bool Collider::isFree(const Instances& instances, Point from, Point to) {
  return std::all_of(instances.all().begin(), instances.all().end(), [&](const Placement& placement) {
    return isFree(placement, placement.at(from), placement.at(to));
  });
}

bool Collider::isFree(const Placement& placement, Point from, Point to) {
  Region& region = start(placement, *placement.shape, from, to);
  for (std::size_t entry = 0; entry < checkedEntries(region); ++entry) {
    if (clip(placement, region, entry) && blocksOrRecord(placement, region.segments()[entry])) return false;
  }
  return true;
}

bool Collider::mayOverlap(const Placement& placement, const Box& box) {
  return coveringRegion(placement, box).mayOverlap(box);
}

std::optional<std::uint32_t> Collider::overlapped(const Placement& placement, const Convex& shape) {
  for (const std::uint32_t segment : start(placement, shape, placement.position, placement.position).segments()) {
    if (sweep_.against(placement.part->segments[segment]) && blocks(placement, segment)) return segment;
  }
  return std::nullopt;
}

void Collider::recordOverlapped(const Placement& placement) {
  Region& region = start(placement, *placement.shape, placement.position, placement.position);
  for (std::size_t entry = 0; entry < checkedEntries(region); ++entry) {
    if (clip(placement, region, entry)) record(refOf(placement, region.segments()[entry]));
  }
}

bool Collider::hasSegmentNear(const Placement& placement, Point point, std::int32_t distance, std::uint32_t ignored) {
  const Box box = Box{point, point}.grown(distance);
  const Region& region = coveringRegion(placement, box);
  return std::any_of(region.segments().begin(), region.segments().end(), [&](std::uint32_t segment) {
    return segment != ignored && touches(placement.part->segments[segment], box) && blocks(placement, segment);
  });
}

std::optional<Sweep::ClipInterval> Collider::clip(const Placement& placement, const Path& path, std::uint32_t segment) {
  const auto entry = startNear(placement, path, segment);
  return entry ? clip(placement, regionOf(placement), *entry) : std::nullopt;
}

std::optional<Hit> Collider::hit(const Placement& placement, const Path& path, std::uint32_t segment) {
  const auto entry = startNear(placement, path, segment);
  if (!entry) return std::nullopt;
  Region& region = regionOf(placement);
  const auto interval = clip(placement, region, *entry);
  return interval ? std::optional(region.hitOf(*entry, *interval)) : std::nullopt;
}

// Starts sweep_ along the path and returns the entry of the segment. Nothing when the path misses the bounding box of
// the segment.
std::optional<std::size_t> Collider::startNear(const Placement& placement, const Path& path, std::uint32_t segment) {
  sweep_.start(*placement.shape, path.from, path.to - path.from, path.margin);
  if (sweep_.misses(boundsOf(placement.part->segments[segment]))) return std::nullopt;
  Region& region = regionOf(placement);
  const auto entry = region.belongsTo(*placement.part) ? region.entryOf(segment) : std::nullopt;
  return entry ? entry : coveringRegion(placement, sweep_.bounds()).entryOf(segment);
}

}  // namespace platon
