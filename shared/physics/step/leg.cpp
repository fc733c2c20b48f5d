#include "shared/physics/step/leg.h"

#include "platon/exact/integer.h"
#include "shared/physics/ideal_geometry.h"
#include "shared/physics/step/hit_frame.h"
#include "shared/physics/tolerances.h"

namespace platon {
namespace {

class LegSearch {
 public:
  LegSearch(Leg& leg, Mover& mover, PrecisePoint from, const LegHit* slidesOn, std::vector<Collider::WarpRef>& refused)
      : leg_(leg), mover_(mover), instances_(mover.instances()), from_(from), slidesOn_(slidesOn), refused_(refused) {}

  /// Shortens the displacement until all instances stay within the coordinate limit. Returns whether it was too long.
  bool clampToRange();
  /// Finds the earliest hit of any instance.
  void findHit();
  /// Inserts the instances that the leg needs.
  void insertInstances();

 private:
  void findHit(std::size_t index);
  void insertBehind(const LegHit& warpHit);
  void stopAtWarp(const LegHit& warpHit, Leg::End end);
  bool movesAwayFromWarp(const LegHit& warpHit) const;

  Leg& leg_;
  Mover& mover_;
  const Instances& instances_;
  PrecisePoint from_;
  const LegHit* slidesOn_;
  std::vector<Collider::WarpRef>& refused_;
};

bool LegSearch::clampToRange() {
  leg_.target = mover_.roundedAt(from_ + leg_.displacement);
  bool clamped = false;
  for (; leg_.target != mover_.position() && !mover_.allInRange(leg_.target); clamped = true) {
    leg_.displacement = {leg_.displacement.x / 2, leg_.displacement.y / 2};
    leg_.share.denominator *= 2;
    leg_.target = mover_.roundedAt(from_ + leg_.displacement);
    if (leg_.displacement == PrecisePoint()) {  // a contact has put the ideal place itself out of range
      leg_.target = mover_.position();
      leg_.share = {1, 1};  // nothing is left of the displacement, or the leg would be repeated
    }
  }
  return clamped;
}

void LegSearch::findHit() {
  leg_.hit.reset();
  mover_.collider().startLeg(instances_, leg_.target);
  for (std::size_t i = 0; i < instances_.all().size(); ++i) findHit(i);
}

void LegSearch::findHit(std::size_t index) {
  const PrecisePoint displacement =
      index == 0 ? leg_.displacement : rotated(leg_.displacement, instances_.all()[index].fromHome);
  const bool slidesHere = slidesOn_ != nullptr && slidesOn_->placement == index;
  mover_.collider().firstIdeal(instances_, index, instances_.idealOf(index, from_), displacement, leg_.hit,
                               slidesHere ? slidesOn_->segment : Collider::kNoSegment);
  leg_.end = leg_.hit ? Leg::End::kStopped : Leg::End::kReached;
}

void LegSearch::insertInstances() {
  const std::size_t before = instances_.all().size();
  while (leg_.end == Leg::End::kReached || leg_.end == Leg::End::kStopped) {
    const Collider::Path path{mover_.position(), leg_.target, Tolerances::kInsert};
    const auto warpHit = mover_.collider().firstWarp(instances_, path, leg_.hit, refused_);
    if (!warpHit) break;
    insertBehind(*warpHit);
  }
  if (instances_.all().size() != before) mover_.observe();
}

void LegSearch::insertBehind(const LegHit& warpHit) {
  const auto warp = static_cast<std::uint16_t>(placementOf(instances_, warpHit).part->warpOfSegment(warpHit.segment));
  if (instances_.isAtInstanceLimit(warpHit.placement)) {
    stopAtWarp(warpHit, Leg::End::kFull);
  } else if (mover_.insertBehind(warpHit.placement, warp)) {
    if (clampToRange()) {  // the new instance reaches the coordinate limit earlier
      findHit();
    } else {
      findHit(instances_.all().size() - 1);
    }
  } else if (movesAwayFromWarp(warpHit)) {
    refused_.push_back({warpHit.placement, warp});
  } else {
    stopAtWarp(warpHit, Leg::End::kRefused);
  }
}

// The ideal place stops where the lattice position would.
void LegSearch::stopAtWarp(const LegHit& warpHit, Leg::End end) {
  leg_.end = end;
  leg_.hit = warpHit;
  const Point normal = normalOf(instances_, warpHit);
  const PrecisePoint place = instances_.idealOf(warpHit.placement, from_ + scaled(leg_.displacement, warpHit.hit.time));
  const int128 along = distanceTo({normal, 0}, place);
  const Obstacle::HalfPlane half{normal, -static_cast<std::int64_t>(divideRounded(along, int128{PrecisePoint::kOne}))};
  leg_.hit->edge = edgeOf(*placementOf(instances_, warpHit).shape, segmentOf(instances_, warpHit), half);
}

// Whether the leg leads away from the warp segment or along it. It then does not need the instance behind the warp.
bool LegSearch::movesAwayFromWarp(const LegHit& warpHit) const {
  const Placement& placement = placementOf(instances_, warpHit);
  const Segment& segment = segmentOf(instances_, warpHit);
  return dot(perpendicular(segment.b - segment.a), placement.at(leg_.target) - placement.position) >= 0;
}

}  // namespace

void prepareLeg(Leg& leg, Mover& mover, PrecisePoint from, const LegHit* slidesOn,
                std::vector<Collider::WarpRef>& refused) {
  refused.clear();
  LegSearch search(leg, mover, from, slidesOn, refused);
  search.clampToRange();
  search.findHit();
  if (mover.collider().isNearWarps(mover.instances())) search.insertInstances();
}

bool prepareSlide(Leg& leg, Mover& mover, PrecisePoint from, const LegHit& contact, PrecisePoint wanted,
                  std::vector<Collider::WarpRef>& refused) {
  refused.clear();
  LegSearch search(leg, mover, from, &contact, refused);
  if (search.clampToRange()) return false;
  search.findHit();
  if (mover.collider().entersEarlier(mover.instances(), contact.segment, from, wanted)) return false;
  if (mover.collider().isNearWarps(mover.instances())) search.insertInstances();
  return true;
}

}  // namespace platon
