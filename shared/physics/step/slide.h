#pragma once

#include <optional>

#include "platon/exact/fraction.h"
#include "platon/exact/precise_point.h"
#include "shared/physics/collider.h"
#include "shared/physics/ideal_geometry.h"
#include "shared/physics/instances.h"
#include "shared/physics/step/hit_frame.h"
#include "shared/physics/step/leg.h"

namespace platon {

/// The displacement of a leg, of the ideal place.
struct LegPlan {
  PrecisePoint displacement;  ///< ends with the edge that the leg slides along
  Fraction share{1, 1};       ///< of the remaining displacement, that it uses
  bool slides = false;        ///< along the contact
  bool cut = false;           ///< it ends with the edge
};

/// The ideal path during one step: free to the exact contact, then along the exact edge to its exact end. A value:
/// except for rotateFrame, its functions only say where it leads; EntityStep moves it. `instances` must stay valid. All
/// places and displacements are in the frame of the current home part.
struct Slide {
  const Instances& instances;
  PrecisePoint place;                ///< the ideal place of the home instance
  PrecisePoint tick{};               ///< displacement of the whole tick
  PrecisePoint remaining{};          ///< displacement still to be used; parallel to tick
  std::optional<LegHit> contact{};   ///< the edge that the place is on and was stopped by
  std::optional<LegPlan> passing{};  ///< the next leg, on the free path past a segment end

  /// The next leg: past a segment end if `passing` is set; along the contact if that stops the remaining displacement
  /// and its edge does not end here; else free. A slide by (0, 0) is a rest.
  LegPlan next() const;
  /// Where a leg of this plan ends: on the contact if it slides, which requires one, and on the edge that it hits.
  PrecisePoint endOf(const Leg& leg, const LegPlan& plan) const;
  /// What the leg leaves of the remaining displacement.
  PrecisePoint remainingAfter(const Leg& leg, const LegPlan& plan) const;
  /// Where `end` is at the corner that ends the edge of `hit`: changes `hit` to the next edge of the obstacle if that
  /// stops the remaining displacement.
  void turnCorner(LegHit& hit, PrecisePoint end) const;

  /// The slide of the home place `from` by a displacement along the edge that was hit, in the frame of its part.
  EdgeSlide slideFrom(const LegHit& hit, PrecisePoint from, PrecisePoint displacement) const {
    return slideOn(hit.edge, instances.idealOf(hit.placement, from), fromHome(instances, hit, displacement));
  }
  /// Whether `hit` is on the edge of the contact. Requires a contact.
  bool isOnContact(const LegHit& hit) const;
  /// Whether the slide along the edge of `hit`, if that were infinite, at once leads into the contact. Requires one. If
  /// it would rest there: whether the place is inside of the obstacle of the contact.
  bool isCaughtAt(const LegHit& hit) const;
  /// The frame of the home part has been rotated. The indices of the placements have changed with it.
  void rotateFrame(Angle turn);

 private:
  LegPlan slideAlongContact() const;
  bool restsOn(const LegHit& hit) const;
  bool leadsIntoContact(PrecisePoint displacement) const;
};

}  // namespace platon
