#include "tests/shared/physics/step/leg_checker.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "platon/exact/integer.h"
#include "platon/physics/sweep.h"

namespace platon {
namespace {

struct Real {
  long double x, y;
};

Real real(PrecisePoint point) {
  return {static_cast<long double>(point.x) / PrecisePoint::kOne,
          static_cast<long double>(point.y) / PrecisePoint::kOne};
}

// The isometry of the warp in floating point.
Real through(const Warp& warp, Real point) {
  const long double turn = warp.turn.centidegrees() * std::numbers::pi_v<long double> / 18000;
  const Real from = real(warp.fromMiddle);
  const Real onto = real(warp.ontoMiddle);
  const long double x = point.x - from.x;
  const long double y = point.y - from.y;
  return {onto.x + x * std::cos(turn) - y * std::sin(turn), onto.y + x * std::sin(turn) + y * std::cos(turn)};
}

const InstanceView* find(std::span<const InstanceView> all, std::uint16_t id) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const InstanceView& view) { return view.id == id; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace

void LegChecker::leg(std::uint32_t entity, std::span<const InstanceView> instances) {
  ++legs_;
  std::map<std::pair<std::uint32_t, std::uint16_t>, Known> now;
  for (const InstanceView& view : instances) {
    const Convex& shape = shapeOf(entity, view.angle);
    checkFree(entity, view, shape);
    checkPath(entity, view, shape);
    checkPlace(entity, view, instances);
    if (!isCoordinate(view.position.x) || !isCoordinate(view.position.y)) fault(entity, view, "is out of range");
    if (!now.emplace(std::pair(entity, view.id), Known{view.position, view.angle, view.part}).second) {
      fault(entity, view, "has the id of another instance");
    }
  }
  if (instances.empty() || !instances.front().home) faults_ += "the home instance does not come first\n";
  std::erase_if(last_, [&](const auto& known) { return known.first.first == entity; });
  last_.merge(now);
}

bool LegChecker::blocks(const InstanceView& view, std::uint32_t segment) const {
  return !world_.geometry().find(view.part)->isWarp(segment) && (!blocks_ || blocks_(view, segment));
}

const LegChecker::Known* LegChecker::lastOf(std::uint32_t entity, const InstanceView& view) const {
  const auto known = last_.find({entity, view.id});
  return known == last_.end() ? nullptr : &known->second;
}

// Whether the segment may still be left. One that blocks always is never overlapped.
bool LegChecker::overlapped(const Known& last, const Convex& shape, std::uint32_t segment) const {
  Sweep sweep;
  sweep.start(shape, last.position, {});
  return blocks_ && sweep.against(world_.geometry().find(last.part)->segments[segment]).has_value();
}

void LegChecker::checkFree(std::uint32_t entity, const InstanceView& view, const Convex& shape) {
  const MapGeometry& part = *world_.geometry().find(view.part);
  const Known* const last = lastOf(entity, view);
  Sweep sweep;
  sweep.start(shape, view.position, {});
  for (std::uint32_t line = 0; line < part.segments.size(); ++line) {
    if (!blocks(view, line) || !sweep.against(part.segments[line])) continue;
    if (last == nullptr || !overlapped(*last, shape, line))
      fault(entity, view, "overlaps line " + std::to_string(line));
  }
}

void LegChecker::checkPath(std::uint32_t entity, const InstanceView& view, const Convex& shape) {
  const Known* const before = lastOf(entity, view);
  if (before == nullptr) return;
  if (before->part != view.part) fault(entity, view, "has changed its part");
  if (before->angle != view.angle || before->position == view.position) return;
  const MapGeometry& part = *world_.geometry().find(view.part);
  InstanceView start = view;
  start.position = before->position;
  Sweep sweep;
  sweep.start(shape, before->position, view.position - before->position);
  for (std::uint32_t line = 0; line < part.segments.size(); ++line) {
    if (blocks(start, line) && sweep.against(part.segments[line]) && !overlapped(*before, shape, line))
      fault(entity, view, "passed line " + std::to_string(line));
  }
}

void LegChecker::checkPlace(std::uint32_t entity, const InstanceView& view, std::span<const InstanceView> all) {
  std::vector<const Warp*> chain;
  const InstanceView* at = &view;
  while (at->hasParent && chain.size() <= all.size()) {
    const InstanceView* parent = find(all, at->parent);
    if (parent == nullptr) return fault(entity, view, "hangs on nothing");
    const Warp& warp = world_.geometry().find(parent->part)->warps.at(at->warp);
    if (warp.target != at->part) fault(entity, view, "is in a part that its warp does not lead to");
    if (parent->angle + warp.turn != at->angle)
      fault(entity, view, "has an angle that does not follow from that of its parent");
    chain.push_back(&warp);
    at = parent;
  }
  if (chain.empty()) return;
  if (!at->home) return fault(entity, view, "is not connected to the home instance");
  Real ideal{static_cast<long double>(at->position.x), static_cast<long double>(at->position.y)};
  for (auto warp = chain.rbegin(); warp != chain.rend(); ++warp) ideal = through(**warp, ideal);
  const auto error = static_cast<double>(std::hypot(ideal.x - view.position.x, ideal.y - view.position.y));
  if (error > 4) fault(entity, view, "is " + std::to_string(error) + " from its true place");
}

void LegChecker::fault(std::uint32_t entity, const InstanceView& view, const std::string& what) {
  if (faults_.size() > 2000) return;
  faults_ += "leg " + std::to_string(legs_) + ", entity " + std::to_string(entity) + ", instance " +
             std::to_string(view.id) + " in part " + std::to_string(view.part) + " at (" +
             std::to_string(view.position.x) + ", " + std::to_string(view.position.y) + ") turned " +
             std::to_string(view.angle.centidegrees()) + " " + what + "\n";
}

const Convex& LegChecker::shapeOf(std::uint32_t entity, Angle angle) {
  const Convex& base = world_.shapeOf(entity);
  const std::pair key(&base, angle.centidegrees());
  const auto known = shapes_.find(key);
  return known != shapes_.end() ? known->second : shapes_.emplace(key, base.turned(angle).value()).first->second;
}

}  // namespace platon
