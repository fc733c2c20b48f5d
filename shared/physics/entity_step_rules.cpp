// How a step tells the rules what happened.
#include "shared/physics/entity_step.h"

#include <algorithm>
#include <tuple>

#include "platon/exact/integer.h"

namespace platon {

namespace {

// Of an edge that lies flat on a line, the corner may be beyond the line's end; then the end touches.
Point clampedTo(const Segment& line, Point point) {
  const Point along = line.b - line.a;
  if (dot(point - line.a, along) <= 0) return line.a;
  return dot(point - line.b, along) >= 0 ? line.b : point;
}

}  // namespace

void EntityStep::callContact(const LegHit& hit) {
  const Placement& placement = instances_.all()[hit.placement];
  Contact& contact = contacts_.emplace_back();
  contact.segment = segmentRef(*placement.part, hit.line);
  contact.instance = placement.id;
  contact.normal = normalOf(hit);
  contact.point = hit.hit.side == Hit::Side::kSegment
                      ? clampedTo(contact.segment.ends, placement.position + hit.hit.feature)
                      : hit.hit.feature;
  contact.toHome = instances_.home().angle - placement.angle;
  contact.time = hit.hit.time;
  rules_->contact(*entity_, contact);
}

// Beginnings and ends along the straight path that the leg has really taken, from `before` to where home is now.
void EntityStep::callPierced(Point before) {
  events_.clear();
  for (const Collider::Pierced& pierced : collider_.pierced()) appendEvents(pierced, before);
  std::sort(events_.begin(), events_.end(), [](const Event& a, const Event& b) {
    if (a.time != b.time) return a.time < b.time;
    return std::tuple(a.placement, a.line, !a.begins) < std::tuple(b.placement, b.line, !b.begins);
  });
  for (const Event& event : events_) {
    const SegmentRef line = segmentRef(*instances_.all()[event.placement].part, event.line);
    event.begins ? rules_->beginContact(*entity_, line) : rules_->endContact(*entity_, line);
  }
  for (Placement& placement : instances_.all()) placement.fresh = false;
}

void EntityStep::appendEvents(const Collider::Pierced& pierced, Point before) {
  for (std::size_t i = 0; i < instances_.all().size(); ++i) {
    const Placement& placement = instances_.all()[i];
    if (placement.id != pierced.instance || placement.part->id != pierced.part) continue;
    const Point from = placement.at(before);
    if (from == placement.position && !placement.fresh) return;  // nothing begins or ends on the spot
    const auto meeting = collider_.against(placement, {from, placement.position}, pierced.line);
    if (!meeting) return;
    const bool wasInside = meeting->entered == Sweep::Meeting::kNone;
    if (!wasInside || placement.fresh) events_.push_back({meeting->enter, true, i, pierced.line});
    if (!meeting->endsInside) {
      events_.push_back({meeting->exit, false, i, pierced.line});
    }
  }
}

// What is pierceable and overlapped now has been met in this step.
void EntityStep::callOver() {
  events_.clear();
  for (const Collider::Pierced& pierced : collider_.pierced()) appendOverlap(pierced);
  std::sort(events_.begin(), events_.end(), [](const Event& a, const Event& b) {
    return std::tuple(a.placement, a.line) < std::tuple(b.placement, b.line);
  });
  for (const Event& event : events_) {
    rules_->overContact(*entity_, segmentRef(*instances_.all()[event.placement].part, event.line));
  }
}

void EntityStep::appendOverlap(const Collider::Pierced& pierced) {
  for (std::size_t i = 0; i < instances_.all().size(); ++i) {
    const Placement& placement = instances_.all()[i];
    if (placement.id != pierced.instance || placement.part->id != pierced.part) continue;
    if (overlaps(placement, pierced.line)) events_.push_back({{}, false, i, pierced.line});
  }
}

bool EntityStep::overlaps(const Placement& placement, std::uint32_t line) {
  return collider_.against(placement, {placement.position, placement.position}, line).has_value();
}

}  // namespace platon
