#include "shared/physics/collider.h"

#include <algorithm>
#include <utility>

namespace platon {

SegmentRef segmentRef(const MapGeometry& part, std::uint32_t line) {
  return {part.id, line, part.isWarp(line), part.segments[line]};
}

void Collider::begin(Rules& rules, Entity entity, std::vector<Region>& regions) {
  rules_ = &rules;
  ignoresWarps_ = rules.ignoresWarps();
  entity_.emplace(entity);
  regions_ = &regions;
  regions.resize(Instances::kMax);
  pierced_.clear();
}

Region& Collider::start(const Placement& placement, const Convex& shape, Point from, Point to) {
  sweep_.start(shape, from, to - from);
  Region& region = regionOf(placement);
  region.cover(*placement.part, sweep_.bounds().grown(kReach));
  return region;
}

// What the line at a place of the placement's region is to the sweep that has been started with the placement's shape.
std::optional<Sweep::Meeting> Collider::meet(const Placement& placement, Region& region, std::size_t place) {
  if (sweep_.misses(region.bounds(place))) return std::nullopt;
  return sweep_.meet(region.obstacle(place, *placement.shape));
}

bool Collider::blocks(const MapGeometry& part, std::uint32_t line) const {
  return ignoresWarps_ ? !part.isWarp(line) : !rules_->pierce(*entity_, segmentRef(part, line));
}

bool Collider::blocksOrNote(const Placement& placement, std::uint32_t line) {
  if (blocks(*placement.part, line)) return true;
  const Pierced pierced{placement.id, placement.part->id, line};
  if (std::find(pierced_.begin(), pierced_.end(), pierced) == pierced_.end()) pierced_.push_back(pierced);
  return false;
}

std::optional<LegHit> Collider::first(const Instances& instances, Point from, Point to, const LegHit* but) {
  std::optional<LegHit> best;
  for (std::size_t i = 0; i < instances.all().size(); ++i) {
    first(instances, i, from, to, best, but != nullptr && i == but->placement ? but->line : kNoLine);
  }
  return best;
}

void Collider::first(const Instances& instances, std::size_t index, Point from, Point to, std::optional<LegHit>& best,
                     std::uint32_t but) {
  if (isSettled(best)) return;
  const Placement& placement = instances.all()[index];
  Region& region = start(placement, *placement.shape, instances.at(index, from), placement.at(to));
  for (std::size_t place = 0; place < endOfHeeded(region) && !isSettled(best); ++place) {
    const std::uint32_t line = region.lines()[place];
    if (line == but) continue;
    const auto meeting = meet(placement, region, place);
    if (!meeting || !blocksOrNote(placement, line) || (best && meeting->enter >= best->hit.time)) continue;
    best = LegHit{index, line, Sweep::describe(region.obstacle(place, *placement.shape), *meeting)};
  }
}

std::optional<LegHit> Collider::firstWarp(const Instances& instances, const Path& path,
                                          const std::optional<LegHit>& limit, const std::vector<Gate>& shut) {
  if (limit && limit->hit.time.numerator == 0) return std::nullopt;  // `first` may then have left regions out
  std::optional<LegHit> best;
  const LegHit* earliest = limit ? &*limit : nullptr;
  for (std::size_t i = 0; i < instances.all().size(); ++i) {
    const Placement& placement = instances.all()[i];
    const MapGeometry& part = *placement.part;
    Region& region = regionOf(placement);
    bool started = false;
    for (std::size_t place = region.firstWarp(); place < region.lines().size(); ++place) {
      const std::uint32_t line = region.lines()[place];
      const Gate gate{i, static_cast<std::uint16_t>(part.warpOfSegment(line))};
      if (instances.linked(i, gate.warp) || std::find(shut.begin(), shut.end(), gate) != shut.end()) continue;
      if (!std::exchange(started, true)) {
        const Point from = instances.at(i, path.from);
        sweep_.start(*placement.shape, from, placement.at(path.to) - from, path.margin);
      }
      const auto meeting = meet(placement, region, place);
      if (!meeting || (earliest && meeting->enter >= earliest->hit.time) || blocks(part, line)) continue;
      best = LegHit{i, line, Sweep::describe(region.obstacle(place, *placement.shape), *meeting)};
      earliest = &*best;
    }
  }
  return best;
}

bool Collider::meetsWarp(const Instances& instances, const Gate& gate, const Convex& shape, std::int32_t margin) {
  const Placement& placement = instances.all()[gate.placement];
  sweep_.start(shape, placement.position, {}, margin);
  return sweep_.against(placement.part->warps[gate.warp].from) && !instances.linked(gate.placement, gate.warp) &&
         !blocks(*placement.part, placement.part->segmentOfWarp(gate.warp));
}

bool Collider::isFree(const Instances& instances, Point from, Point to) {
  return std::all_of(instances.all().begin(), instances.all().end(), [&](const Placement& placement) {
    return isFree(placement, placement.at(from), placement.at(to));
  });
}

bool Collider::isFree(const Placement& placement, Point from, Point to) {
  Region& region = start(placement, *placement.shape, from, to);
  for (std::size_t place = 0; place < endOfHeeded(region); ++place) {
    if (meet(placement, region, place) && blocksOrNote(placement, region.lines()[place])) return false;
  }
  return true;
}

std::optional<std::uint32_t> Collider::overlapped(const Placement& placement, const Convex& shape) {
  for (const std::uint32_t line : start(placement, shape, placement.position, placement.position).lines()) {
    if (sweep_.against(placement.part->segments[line]) && blocks(*placement.part, line)) return line;
  }
  return std::nullopt;
}

void Collider::appendPierced(const Placement& placement, std::vector<Pierced>& out) {
  Region& region = start(placement, *placement.shape, placement.position, placement.position);
  for (std::size_t place = 0; place < endOfHeeded(region); ++place) {
    const std::uint32_t line = region.lines()[place];
    if (!meet(placement, region, place) || blocks(*placement.part, line)) continue;
    out.push_back({placement.id, placement.part->id, line});
  }
}

std::optional<Sweep::Meeting> Collider::against(const Placement& placement, const Path& path, std::uint32_t line) {
  Obstacle* obstacle = obstacleNear(placement, path, line);
  return obstacle ? sweep_.meet(*obstacle) : std::nullopt;
}

std::optional<Hit> Collider::hit(const Placement& placement, const Path& path, std::uint32_t line) {
  Obstacle* obstacle = obstacleNear(placement, path, line);
  return obstacle ? sweep_.against(*obstacle) : std::nullopt;
}

// Starts the sweep; null when that passes the bounds of the line.
Obstacle* Collider::obstacleNear(const Placement& placement, const Path& path, std::uint32_t line) {
  sweep_.start(*placement.shape, path.from, path.to - path.from, path.margin);
  if (sweep_.misses(boundsOf(placement.part->segments[line]))) return nullptr;
  Region& region = regionOf(placement);
  auto place = region.isOf(*placement.part) ? region.placeOf(line) : std::nullopt;
  if (!place) {
    region.cover(*placement.part, sweep_.bounds().grown(kReach));
    place = region.placeOf(line);
  }
  return place ? &region.obstacle(*place, *placement.shape) : nullptr;
}

}  // namespace platon
