// Calls of the rules during a step.
#include "shared/physics/entity_step.h"

#include <algorithm>
#include <tuple>

#include "platon/exact/integer.h"

namespace platon {

namespace {

// The point of the segment nearest to a point on its line. When an edge of the shape is parallel to the segment, the
// touching vertex may be beyond the segment's end.
Point clampedTo(const Segment& segment, Point point) {
  const Point along = segment.b - segment.a;
  if (dot(point - segment.a, along) <= 0) return segment.a;
  return dot(point - segment.b, along) >= 0 ? segment.b : point;
}

}  // namespace

void EntityStep::callContact(const LegHit& hit) {
  const Placement& placement = instances_.all()[hit.placement];
  Contact& contact = contacts_.emplace_back();
  contact.segment = segmentRef(*placement.part, hit.segment);
  contact.instance = placement.id;
  contact.normal = normalOf(hit);
  contact.point = hit.hit.side == Hit::Side::kSegment
                      ? clampedTo(contact.segment.ends, placement.position + hit.hit.feature)
                      : hit.hit.feature;
  contact.toHome = instances_.home().angle - placement.angle;
  contact.time = hit.hit.time;
  rules_->contact(*entity_, contact);
}

// Calls beginContact and endContact for the path of the leg, from `before` to the current home position.
void EntityStep::callPierced(Point before) {
  events_.clear();
  for (const Collider::Pierced& pierced : collider_.pierced()) appendEvents(pierced, before);
  std::sort(events_.begin(), events_.end(), [](const Event& a, const Event& b) {
    if (a.time != b.time) return a.time < b.time;
    return std::tuple(a.placement, a.segment, !a.begins) < std::tuple(b.placement, b.segment, !b.begins);
  });
  for (const Event& event : events_) {
    const SegmentRef segment = segmentRef(*instances_.all()[event.placement].part, event.segment);
    event.begins ? rules_->beginContact(*entity_, segment) : rules_->endContact(*entity_, segment);
  }
  for (Placement& placement : instances_.all()) placement.fresh = false;
}

void EntityStep::appendEvents(const Collider::Pierced& pierced, Point before) {
  for (std::size_t i = 0; i < instances_.all().size(); ++i) {
    const Placement& placement = instances_.all()[i];
    if (placement.id != pierced.instance || placement.part->id != pierced.part) continue;
    const Point from = placement.at(before);
    if (from == placement.position && !placement.fresh) return;  // no move, no event
    const auto interval = collider_.clip(placement, {from, placement.position}, pierced.segment);
    if (!interval) return;
    const bool wasInside = interval->entered == Sweep::ClipInterval::kNone;
    if (!wasInside || placement.fresh) events_.push_back({interval->enter, true, i, pierced.segment});
    if (!interval->endsInside) {
      events_.push_back({interval->exit, false, i, pierced.segment});
    }
  }
}

// Every segment that is overlapped now was recorded during this step.
void EntityStep::callOver() {
  events_.clear();
  for (const Collider::Pierced& pierced : collider_.pierced()) appendOverlap(pierced);
  std::sort(events_.begin(), events_.end(), [](const Event& a, const Event& b) {
    return std::tuple(a.placement, a.segment) < std::tuple(b.placement, b.segment);
  });
  for (const Event& event : events_) {
    rules_->overContact(*entity_, segmentRef(*instances_.all()[event.placement].part, event.segment));
  }
}

void EntityStep::appendOverlap(const Collider::Pierced& pierced) {
  for (std::size_t i = 0; i < instances_.all().size(); ++i) {
    const Placement& placement = instances_.all()[i];
    if (placement.id != pierced.instance || placement.part->id != pierced.part) continue;
    if (overlaps(placement, pierced.segment)) events_.push_back({{}, false, i, pierced.segment});
  }
}

bool EntityStep::overlaps(const Placement& placement, std::uint32_t segment) {
  return collider_.clip(placement, {placement.position, placement.position}, segment).has_value();
}

}  // namespace platon
