#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "platon/exact/fraction.h"
#include "platon/exact/point.h"
#include "platon/exact/precise_point.h"
#include "shared/physics/collider.h"
#include "shared/physics/ideal_geometry.h"
#include "shared/physics/step/step_state.h"

namespace platon {

/// The stages of a leg, in the order in which entity_step.cpp runs them: plan the leg and find its end (leg.cpp); pass
/// a segment end that protrudes (segment_ends.cpp); lead the position after the ideal place (follow.cpp).

/// One straight move of the ideal place, and what ends it.
struct Leg {
  enum class End : std::uint8_t {
    kReached,
    kStopped,  ///< hit a blocking segment
    kRefused,  ///< an instance that the leg needs cannot be placed
    kFull,     ///< the limit of instances is reached
  };
  LegPlan plan{};
  PrecisePoint displacement = plan.displacement;  ///< of the ideal place, if nothing is hit
  Point target{};                                 ///< of the position, if nothing is hit
  Fraction share{1, 1};  ///< of the planned displacement: less if that leads out of the coordinates
  End end = End::kReached;
  std::optional<LegHit> hit{};  ///< the blocking segment or warp segment that ends it
  bool lacksInstance = false;   ///< one that cannot be placed, behind a warp that the leg leads away from

  bool isStopped() const { return hit && end != End::kFull; }
};

/// The next leg: past a segment end if `passing` is set; along the contact if that stops the remaining displacement and
/// its edge does not end here; else free. A slide by (0, 0) is a rest.
LegPlan planLeg(const StepState& step);
/// Finds where a leg of this plan ends, and inserts the instances that it needs: before the leg, while their shape is
/// still outside of their part and therefore free.
Leg findLeg(StepState& step, const LegPlan& plan);
/// The same for a slide along a contact of the home instance that the remaining displacement has met at once. Nothing,
/// and inserts nothing, if it would have met another segment instead, or if the leg would leave the coordinates.
std::optional<Leg> findSlide(StepState& step, const LegPlan& plan);
/// The ideal place at the end of the leg: on the contact if it slides, which requires one, and on the edge that it
/// hits.
PrecisePoint placeAfter(const StepState& step, const Leg& leg);
/// What the leg leaves of the remaining displacement.
PrecisePoint remainingAfter(const StepState& step, const Leg& leg);
/// Where `end` is at the corner that ends the edge of `hit`: changes `hit` to the next edge of the obstacle if that
/// stops the remaining displacement.
void turnCorner(const StepState& step, LegHit& hit, PrecisePoint end);

/// The slide of the home place `from` by a displacement along the edge that was hit, in the frame of its part.
inline EdgeSlide slideFrom(const StepState& step, const LegHit& hit, PrecisePoint from, PrecisePoint displacement) {
  return slideAlong(hit.edge, step.instances.idealOf(hit.placement, from), fromHome(step.instances, hit, displacement));
}
/// Whether `hit` is on the edge of the contact. Requires a contact.
bool isOnContact(const StepState& step, const LegHit& hit);
/// Whether the slide along the edge of `hit`, if that were infinite, at once leads into the contact. Requires one. If
/// it would rest there: whether the place is inside of the obstacle of the contact.
bool isCaughtAt(const StepState& step, const LegHit& hit);

/// A way past a segment end that protrudes slightly at a joint (I3).
struct Nudge {
  Point to;       ///< the position beside the end, to which the straight way is free
  Point onwards;  ///< the displacement from there that leads past the end
};
/// Whether an end, hit at the ideal place `at` with `remaining` left of the displacement, stops the ideal place or
/// leaves it less than 1/32 of its speed. Otherwise it slides along the end, as it does if the end is past in 1/32 of
/// the remaining time. `step` is as it was before the leg.
bool isBlockedByEnd(const StepState& step, const LegHit& hit, PrecisePoint at, PrecisePoint remaining);
/// The way past the segment end that `hit` touches, from an edge with this normal in the home frame, on which the ideal
/// place is at `at` and slides with `remaining` left of the displacement. Where the normal is that of the end itself,
/// it goes straight on. Nothing if `hit` touches no end, or if the end does not protrude slightly at a joint.
std::optional<Nudge> findNudge(StepState& step, const LegHit& hit, Point normal, PrecisePoint at,
                               PrecisePoint remaining);

/// Moves the position near to the ideal place `end`, on the outer side of what was hit, if that is not null. It takes
/// at most two straight moves, which the exact sweep proves free (I1). Returns false if there is no such way to a place
/// within Tolerances::kFollow of the rounded ideal place: it has then moved nothing, or made the first of two moves, if
/// after it Rules::pierce blocks the second. Requires that the instances have not moved since the leg was found.
bool follow(StepState& step, PrecisePoint end, const LegHit* hit);
/// Moves the position towards `end` as far as the lattice allows. Returns whether it moved.
bool fallBack(StepState& step, PrecisePoint end);

/// The events of the step, in order of time. The contacts with pierced segments follow from what the entity overlaps:
/// Collider::overlapped is compared with it after every move, rotation and removal of an instance. So they begin and
/// end alternately.

/// Lets all instances but `except` pass what they overlap, until they have left it.
void pierceOverlapped(StepState& step, std::uint16_t except = InstanceState::kNoParent);
/// As above, for all instances. The contacts of fresh instances begin.
void beginContacts(StepState& step);
/// Appends the contacts that have begun, after pierceOverlapped: those of instances that are not fresh.
void appendContacts(const StepState& step, std::vector<SegmentRef>& out);

/// A blocking segment stopped a move.
void addContact(StepState& step, const LegHit& hit);
/// A blocking segment stopped a rotation.
void addTouch(StepState& step, const SegmentRef& segment);
/// All instances have moved straight, the home instance from `before` to its position.
void updateMoved(StepState& step, Point before);
/// Instances have been removed, or the step ends: adds first the contacts that have ended, then those that have begun.
void updateContacts(StepState& step);
/// The shape has been rotated: records what it overlaps now, then updateContacts.
void updateRotated(StepState& step);
/// Ends the step: adds overContact for all overlapped segments.
void finishContacts(StepState& step);

}  // namespace platon
