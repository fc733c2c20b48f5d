#include "shared/physics/step/step_contacts.h"

#include <algorithm>
#include <iterator>
#include <tuple>

#include "shared/physics/step/hit_frame.h"

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

void StepContacts::addContact(const LegHit& hit) {
  const Placement& placement = placementOf(instances_, hit);
  Contact& contact = events_.add(StepEvents::Kind::kContact, entity_);
  contact.segment = collider_.refOf(placement, hit.segment);
  contact.normal = normalOf(instances_, hit);
  contact.point = hit.hit.side == Hit::Side::kSegment
                      ? clampedTo(contact.segment.ends, placement.position + hit.hit.feature)
                      : hit.hit.feature;
  contact.time = hit.hit.time;
}

void StepContacts::pierceOverlapped(std::uint16_t except) {
  if (collider_.scope() == Rules::Scope::kContacts) return;
  for (const Placement& placement : instances_.all()) {
    if (placement.id != except) collider_.recordOverlapped(placement);
  }
  collider_.overlapped() = collider_.pierced();
}

void StepContacts::begin() {
  pierceOverlapped();
  for (const SegmentRef& ref : collider_.overlapped()) {
    if (instances_.all()[indexOf(ref)].fresh) add(StepEvents::Kind::kBegin, ref);
  }
  clearFresh();
}

void StepContacts::append(std::vector<SegmentRef>& out) const {
  std::copy_if(collider_.pierced().begin(), collider_.pierced().end(), std::back_inserter(out),
               [&](const SegmentRef& ref) { return !instances_.all()[indexOf(ref)].fresh; });
}

void StepContacts::clearFresh() {
  for (Placement& placement : instances_.all()) placement.fresh = false;
}

void StepContacts::updatePierced(Point before) {
  changes_.clear();
  for (const SegmentRef& pierced : collider_.pierced()) appendChanges(pierced, before);
  applyChanges();
}

void StepContacts::updateRotated() {
  if (collider_.scope() == Rules::Scope::kContacts) return;
  for (const Placement& placement : instances_.all()) collider_.recordOverlapped(placement);
  update();
}

void StepContacts::finish(Angle turn) {
  update();
  if (!collider_.overlapped().empty()) addOver();
  clearFresh();
  events_.turnHome(firstEvent_, turn);
}

void StepContacts::update() {
  if (collider_.pierced().empty()) return;
  changes_.clear();
  for (const SegmentRef& pierced : collider_.pierced()) appendChanges(pierced, instances_.home().position);
  for (Change& change : changes_) change.time = {change.begins ? 1 : 0, 1};
  applyChanges();
}

void StepContacts::appendChanges(const SegmentRef& pierced, Point before) {
  const bool hadBegun = Collider::contains(collider_.overlapped(), pierced);
  const std::size_t index = indexOf(pierced);
  if (index == Placement::kNone) {
    if (hadBegun) changes_.push_back({{0, 1}, false, index, pierced});
    return;
  }
  const Placement& placement = instances_.all()[index];
  const auto interval = collider_.clip(placement, {placement.at(before), placement.position}, pierced.index);
  const SegmentRef ref = collider_.refOf(placement, pierced.index);
  if (interval && !hadBegun) changes_.push_back({interval->enter, true, index, ref});
  if (interval && !interval->endsInside) changes_.push_back({interval->exit, false, index, ref});
  if (!interval && hadBegun) changes_.push_back({{0, 1}, false, index, ref});
}

void StepContacts::applyChanges() {
  std::sort(changes_.begin(), changes_.end(), [](const Change& a, const Change& b) {
    if (a.time != b.time) return a.time < b.time;
    return std::tuple(a.placement, a.segment.instance, a.segment.index, !a.begins) <
           std::tuple(b.placement, b.segment.instance, b.segment.index, !b.begins);
  });
  auto& open = collider_.overlapped();
  for (const Change& change : changes_) {
    if (change.begins) {
      open.push_back(change.segment);
    } else {
      std::erase_if(open, [&](const SegmentRef& ref) { return Collider::isSame(ref, change.segment); });
    }
    add(change.begins ? StepEvents::Kind::kBegin : StepEvents::Kind::kEnd, change.segment);
  }
}

// The index of the instance among the placements, or Placement::kNone. An id that was tried in vain may have been given
// to an instance in another part.
std::size_t StepContacts::indexOf(const SegmentRef& ref) const {
  const auto& all = instances_.all();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Placement& placement) {
    return placement.id == ref.instance && placement.part->id == ref.part;
  });
  return found == all.end() ? Placement::kNone : static_cast<std::size_t>(found - all.begin());
}

void StepContacts::addOver() {
  changes_.clear();
  for (const SegmentRef& ref : collider_.overlapped()) changes_.push_back({{}, true, indexOf(ref), ref});
  std::sort(changes_.begin(), changes_.end(), [](const Change& a, const Change& b) {
    return std::tuple(a.placement, a.segment.index) < std::tuple(b.placement, b.segment.index);
  });
  for (const Change& change : changes_) add(StepEvents::Kind::kOver, change.segment);
}

}  // namespace platon
