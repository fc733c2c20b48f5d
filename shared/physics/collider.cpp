#include "shared/physics/collider.h"

#include <algorithm>

namespace platon {

LineRef lineRef(const MapGeometry& part, std::uint32_t line) {
  return {part.id, line, part.isWarp(line), part.lines[line]};
}

void Collider::begin(Rules& rules, Entity entity, std::vector<Region>& regions) {
  rules_ = &rules;
  entity_.emplace(entity);
  regions_ = &regions;
  pierced_.clear();
}

const std::vector<std::uint32_t>& Collider::start(const Placement& placement, const Convex& shape, Point from,
                                                  Point to, std::int32_t margin) {
  sweep_.start(shape, from, to - from, margin);
  if (regions_->size() <= placement.region) regions_->resize(placement.region + 1);
  Region& region = (*regions_)[placement.region];
  region.cover(*placement.part, sweep_.bounds().grown(kReach));
  return region.lines();
}

bool Collider::blocks(const MapGeometry& part, std::uint32_t line) const {
  return !rules_->pierce(*entity_, lineRef(part, line));
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

void Collider::first(const Instances& instances, std::size_t index, Point from, Point to,
                     std::optional<LegHit>& best, std::uint32_t but) {
  const Placement& placement = instances.all()[index];
  const auto& lines = start(placement, *placement.shape, placement.at(from), placement.at(to), 0);
  for (const std::uint32_t line : lines) {
    if (line == but) continue;
    const auto hit = sweep_.against(placement.part->lines[line]);
    if (!hit || !blocksOrNote(placement, line)) continue;
    if (!best || hit->time < best->hit.time) best = LegHit{index, line, *hit};
  }
}

std::optional<LegHit> Collider::firstWarp(const Instances& instances, const Path& path,
                                          const std::optional<LegHit>& limit, const std::vector<Gate>& shut) {
  std::optional<LegHit> best = limit;
  bool found = false;
  for (std::size_t i = 0; i < instances.all().size(); ++i) {
    const Placement& placement = instances.all()[i];
    const MapGeometry& part = *placement.part;
    if (part.warps.empty()) continue;
    sweep_.start(*placement.shape, placement.at(path.from), placement.at(path.to) - placement.at(path.from),
                 path.margin);
    for (std::uint16_t warp = 0; warp < part.warps.size(); ++warp) {
      const auto hit = sweep_.against(part.warps[warp].from);
      if (!hit || (best && hit->time >= best->hit.time) || !isOpen(instances, {i, warp}, shut)) continue;
      best = LegHit{i, part.lineOfWarp(warp), *hit};
      found = true;
    }
  }
  return found ? best : std::nullopt;
}

bool Collider::isOpen(const Instances& instances, const Gate& gate, const std::vector<Gate>& shut) const {
  const MapGeometry& part = *instances.all()[gate.placement].part;
  return !instances.linked(gate.placement, gate.warp) && std::find(shut.begin(), shut.end(), gate) == shut.end() &&
         !blocks(part, part.lineOfWarp(gate.warp));
}

bool Collider::meetsWarp(const Instances& instances, const Gate& gate, const Convex& shape, std::int32_t margin) {
  const Placement& placement = instances.all()[gate.placement];
  sweep_.start(shape, placement.position, {}, margin);
  return sweep_.against(placement.part->warps[gate.warp].from) && isOpen(instances, gate, {});
}

bool Collider::isFree(const Instances& instances, Point from, Point to) {
  return std::all_of(instances.all().begin(), instances.all().end(), [&](const Placement& placement) {
    return isFree(placement, placement.at(from), placement.at(to));
  });
}

bool Collider::isFree(const Placement& placement, Point from, Point to) {
  const auto& lines = start(placement, *placement.shape, from, to, 0);
  return std::none_of(lines.begin(), lines.end(), [&](std::uint32_t line) {
    return sweep_.against(placement.part->lines[line]) && blocksOrNote(placement, line);
  });
}

std::optional<std::uint32_t> Collider::overlapped(const Placement& placement, const Convex& shape) {
  for (const std::uint32_t line : start(placement, shape, placement.position, placement.position, 0)) {
    if (sweep_.against(placement.part->lines[line]) && blocks(*placement.part, line)) return line;
  }
  return std::nullopt;
}

void Collider::appendPierced(const Placement& placement, std::vector<Pierced>& out) {
  for (const std::uint32_t line : start(placement, *placement.shape, placement.position, placement.position, 0)) {
    if (!sweep_.against(placement.part->lines[line]) || blocks(*placement.part, line)) continue;
    out.push_back({placement.id, placement.part->id, line});
  }
}

std::optional<Hit> Collider::against(const Placement& placement, Point from, Point to, const Segment& line) {
  sweep_.start(*placement.shape, from, to - from);
  return sweep_.against(line);
}

}  // namespace platon
