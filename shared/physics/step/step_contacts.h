#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "platon/exact/fraction.h"
#include "platon/physics/rules.h"
#include "shared/physics/collider.h"
#include "shared/physics/instances.h"
#include "shared/physics/step/step_events.h"

namespace platon {

/// Adds the events of one entity's step, in order of time. The contacts with pierced segments follow from what the
/// entity overlaps: Collider::overlapped is compared with it after every move, rotation and removal of an instance. So
/// they begin and end alternately.
class StepContacts {
 public:
  /// The begin or end of a contact.
  struct Change {
    Fraction time;
    bool begins;
    std::size_t placement;  ///< Placement::kNone when the instance no longer exists
    SegmentRef segment;
  };

  /// `changes` is work space. All references must stay valid as long as the object.
  StepContacts(EntityId entity, Instances& instances, Collider& collider, StepEvents& events,
               std::vector<Change>& changes)
      : entity_(entity),
        instances_(instances),
        collider_(collider),
        events_(events),
        firstEvent_(events.size()),
        changes_(changes) {}

  /// Lets all instances but `except` pass what they overlap, until they have left it.
  void pierceOverlapped(std::uint16_t except = InstanceState::kNoParent);
  /// As above, for all instances. The contacts of fresh instances begin.
  void begin();
  /// Appends the contacts that have begun, after pierceOverlapped: those of instances that are not fresh.
  void append(std::vector<SegmentRef>& out) const;

  /// A blocking segment stopped a move.
  void addContact(const LegHit& hit);
  /// A blocking segment stopped a rotation.
  void addTouch(const SegmentRef& segment) { add(StepEvents::Kind::kTouch, segment); }
  /// All instances have moved straight, the home instance from `before` to its position.
  void updateMoved(Point before) {
    if (!collider_.pierced().empty()) updatePierced(before);
  }
  /// Instances have been removed, or the step ends: adds first the contacts that have ended, then those that have
  /// begun.
  void update();
  /// The shape has been rotated: records what it overlaps now, then `update`.
  void updateRotated();
  /// Ends the step, during which the frame of the home part has turned by `turn`: adds overContact for all overlapped
  /// segments.
  void finish(Angle turn);

 private:
  void add(StepEvents::Kind kind, const SegmentRef& segment) { events_.add(kind, entity_).segment = segment; }
  void updatePierced(Point before);
  void appendChanges(const SegmentRef& pierced, Point before);
  void applyChanges();
  void addOver();
  std::size_t indexOf(const SegmentRef& ref) const;
  void clearFresh();

  EntityId entity_;
  Instances& instances_;
  Collider& collider_;
  StepEvents& events_;
  std::size_t firstEvent_;  // of this step
  std::vector<Change>& changes_;
};

}  // namespace platon
