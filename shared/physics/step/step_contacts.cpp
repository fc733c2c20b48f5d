#include <algorithm>
#include <iterator>
#include <tuple>

#include "shared/physics/step/stages.h"

namespace platon {
namespace {

// The point of the segment nearest to a point on its line. When an edge of the shape is parallel to the segment, the
// touching vertex may be beyond the segment's end.
Point clampedTo(const Segment& segment, Point point) {
  const Point along = segment.b - segment.a;
  if (dot(point - segment.a, along) <= 0) return segment.a;
  return dot(point - segment.b, along) >= 0 ? segment.b : point;
}

void add(StepState& step, StepEvents::Kind kind, const SegmentRef& segment) {
  step.events.add(kind, step.id).segment = segment;
}

// The index of the instance among the placements, or Placement::kNone. An id that was tried in vain may have been given
// to an instance in another part.
std::size_t indexOf(const Instances& instances, const SegmentRef& ref) {
  const auto& all = instances.all();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Placement& placement) {
    return placement.id == ref.instance && placement.part->id == ref.part;
  });
  return found == all.end() ? Placement::kNone : static_cast<std::size_t>(found - all.begin());
}

void clearFresh(StepState& step) {
  for (Placement& placement : step.instances.all()) placement.fresh = false;
}

void recordOverlapped(StepState& step, std::uint16_t except) {
  for (const Placement& placement : step.instances.all()) {
    if (placement.id != except) step.collider.recordOverlapped(placement);
  }
}

// The home instance has moved straight from `before` to its position, and all others with it.
void findChanges(StepState& step, const SegmentRef& pierced, Point before, std::vector<ContactChange>& changes) {
  const bool hadBegun = Collider::contains(step.collider.overlapped(), pierced);
  const std::size_t index = indexOf(step.instances, pierced);
  if (index == Placement::kNone) {
    if (hadBegun) changes.push_back({{0, 1}, false, index, pierced});
    return;
  }
  const Placement& placement = step.instances.all()[index];
  const auto interval = step.collider.clip(placement, {placement.at(before), placement.position}, pierced.index);
  const SegmentRef ref = step.collider.refOf(placement, pierced.index);
  if (interval && !hadBegun) changes.push_back({interval->enter, true, index, ref});
  if (interval && !interval->endsInside) changes.push_back({interval->exit, false, index, ref});
  if (!interval && hadBegun) changes.push_back({{0, 1}, false, index, ref});
}

std::vector<ContactChange>& changesSince(StepState& step, Point before) {
  std::vector<ContactChange>& changes = step.buffers.changes;
  changes.clear();
  for (const SegmentRef& pierced : step.collider.pierced()) findChanges(step, pierced, before, changes);
  return changes;
}

void apply(StepState& step, std::vector<ContactChange>& changes) {
  std::sort(changes.begin(), changes.end(), [](const ContactChange& a, const ContactChange& b) {
    if (a.time != b.time) return a.time < b.time;
    return std::tuple(a.placement, a.segment.instance, a.segment.index, !a.begins) <
           std::tuple(b.placement, b.segment.instance, b.segment.index, !b.begins);
  });
  auto& open = step.collider.overlapped();
  for (const ContactChange& change : changes) {
    if (change.begins) {
      open.push_back(change.segment);
    } else {
      std::erase_if(open, [&](const SegmentRef& ref) { return Collider::isSame(ref, change.segment); });
    }
    add(step, change.begins ? StepEvents::Kind::kBegin : StepEvents::Kind::kEnd, change.segment);
  }
}

void addOver(StepState& step) {
  std::vector<ContactChange>& changes = step.buffers.changes;
  changes.clear();
  for (const SegmentRef& ref : step.collider.overlapped())
    changes.push_back({{}, true, indexOf(step.instances, ref), ref});
  std::sort(changes.begin(), changes.end(), [](const ContactChange& a, const ContactChange& b) {
    return std::tuple(a.placement, a.segment.index) < std::tuple(b.placement, b.segment.index);
  });
  for (const ContactChange& change : changes) add(step, StepEvents::Kind::kOver, change.segment);
}

}  // namespace

void pierceOverlapped(StepState& step, std::uint16_t except) {
  if (step.collider.scope() == Rules::Scope::kContacts) return;
  recordOverlapped(step, except);
  step.collider.overlapped() = step.collider.pierced();
}

void beginContacts(StepState& step) {
  pierceOverlapped(step);
  for (const SegmentRef& ref : step.collider.overlapped()) {
    if (step.instances.all()[indexOf(step.instances, ref)].fresh) add(step, StepEvents::Kind::kBegin, ref);
  }
  clearFresh(step);
}

void appendContacts(const StepState& step, std::vector<SegmentRef>& out) {
  const std::vector<SegmentRef>& pierced = step.collider.pierced();
  std::copy_if(pierced.begin(), pierced.end(), std::back_inserter(out),
               [&](const SegmentRef& ref) { return !step.instances.all()[indexOf(step.instances, ref)].fresh; });
}

void addContact(StepState& step, const LegHit& hit) {
  const Placement& placement = placementOf(step.instances, hit);
  Contact& contact = step.events.add(StepEvents::Kind::kContact, step.id);
  contact.segment = step.collider.refOf(placement, hit.segment);
  contact.normal = normalOf(step.instances, hit);
  contact.point = hit.hit.side == Hit::Side::kSegment
                      ? clampedTo(contact.segment.ends, placement.position + hit.hit.feature)
                      : hit.hit.feature;
  contact.time = hit.hit.time;
}

void addTouch(StepState& step, const SegmentRef& segment) { add(step, StepEvents::Kind::kTouch, segment); }

void updateMoved(StepState& step, Point before) {
  if (!step.collider.pierced().empty()) apply(step, changesSince(step, before));
}

void updateContacts(StepState& step) {
  if (step.collider.pierced().empty()) return;
  std::vector<ContactChange>& changes = changesSince(step, step.position());
  for (ContactChange& change : changes) change.time = {change.begins ? 1 : 0, 1};
  apply(step, changes);
}

void updateRotated(StepState& step) {
  if (step.collider.scope() == Rules::Scope::kContacts) return;
  recordOverlapped(step, InstanceState::kNoParent);
  updateContacts(step);
}

void finishContacts(StepState& step) {
  updateContacts(step);
  if (!step.collider.overlapped().empty()) addOver(step);
  clearFresh(step);
  step.events.turnHome(step.firstEvent, step.entity.heading - step.headingBefore);
}

}  // namespace platon
