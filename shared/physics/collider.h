#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "platon/physics/entity.h"
#include "platon/physics/rules.h"
#include "platon/physics/sweep.h"
#include "shared/physics/instances.h"
#include "shared/physics/region.h"

namespace platon {

/// The segment that stops a leg, or a warp segment that a leg reaches.
struct LegHit {
  std::size_t placement = 0;  ///< index of the placement that hits the segment
  std::uint32_t segment = 0;  ///< index into the segments of the placement's part
  Hit hit;                    ///< times are fractions of the leg
  ObstacleEdge edge{};        ///< the edge of the obstacle that the ideal path enters; empty in hits of a lattice path
};

/// A hit belongs to the frame of the part in which it happens, the ideal path to the frame of the home part. These
/// functions lead from one to the other.

/// The instance that hits.
inline const Placement& placementOf(const Instances& instances, const LegHit& hit) {
  return instances.all()[hit.placement];
}
/// The segment that is hit, in the frame of its part.
inline const Segment& segmentOf(const Instances& instances, const LegHit& hit) {
  return placementOf(instances, hit).part->segments[hit.segment];
}
/// A displacement in the frame of the part whose segment was hit.
inline PrecisePoint fromHome(const Instances& instances, const LegHit& hit, PrecisePoint displacement) {
  return hit.placement == 0 ? displacement : rotated(displacement, placementOf(instances, hit).fromHome);
}
/// And back.
inline PrecisePoint toHome(const Instances& instances, const LegHit& hit, PrecisePoint displacement) {
  return hit.placement == 0 ? displacement : rotated(displacement, placementOf(instances, hit).toHome);
}
/// The normal of a hit. For a warp segment that the shape with margin overlaps already: the direction into its part.
Point normalOf(const Instances& instances, const LegHit& hit);
/// The same in the frame of the home part.
Point homeNormalOf(const Instances& instances, const LegHit& hit);

/// Exact collision queries for all instances of one entity. The rules decide which segments block.
class Collider {
 public:
  /// Regions extend this far, in subunits, beyond the path of a leg, so that queries with a margin and for positions
  /// near the end of the leg do not refill them.
  static constexpr std::int32_t kRegionMargin = 8;
  static constexpr std::uint32_t kNoSegment = ~std::uint32_t{0};

  /// A warp of the part of a placement.
  struct WarpRef {
    std::size_t placement;
    std::uint16_t warp;

    friend bool operator==(const WarpRef&, const WarpRef&) = default;
  };
  /// A straight move of a shape with a margin.
  struct Path {
    Point from;
    Point to;
    std::int32_t margin = 0;
  };

  /// Starts a step of an entity with these instances. `regions` belong to it and are indexed by Placement::region.
  void begin(Rules& rules, Entity entity, const Instances& instances, std::vector<Region>& regions, Region::Work& work);
  /// Ensures that there are regions 0 to `last`.
  void provideRegion(std::size_t last) {
    if (last >= regions_->size()) regions_->resize(last + 1);
  }
  /// The shape has been rotated by `angle`.
  void turnShape(Angle angle) { angle_ = angle_ + angle; }
  /// What the rules ask for.
  Rules::Scope scope() const { return scope_; }

  /// The earliest hit of any instance on a blocking segment when the home instance moves straight from `from` to `to`.
  /// At equal times, the first placement and the lowest segment index win. Records pierceable segments on the path.
  std::optional<LegHit> first(const Instances& instances, Point from, Point to);
  /// As above for placement `index` only. Replaces `best` by an earlier hit.
  void first(const Instances& instances, std::size_t index, Point from, Point to, std::optional<LegHit>& best);
  /// Starts the calls of `firstIdeal` for a leg whose lattice path leads the home instance from its position to `to`.
  void startLeg(const Instances& instances, Point to);
  /// Where the ideal path of placement `index` first enters the obstacle of a blocking segment. The lattice path of the
  /// leg must be near it. Replaces `best` by an earlier hit. Does not compare the path with segment `ignored`.
  void firstIdeal(const Instances& instances, std::size_t index, PrecisePoint idealFrom, PrecisePoint displacement,
                  std::optional<LegHit>& best, std::uint32_t ignored = kNoSegment);
  /// How the home instance, at the ideal place `ideal`, meets this segment of its part, if the displacement leads at
  /// once into an edge of its obstacle, far from the others. Only of segments that always block and were near before.
  std::optional<LegHit> touching(const Instances& instances, std::uint32_t segment, PrecisePoint ideal,
                                 PrecisePoint displacement);
  /// Whether, at that place, the displacement leads at once into a blocking segment with a lower index, so that
  /// `firstIdeal` would find that. Must follow `firstIdeal` for a leg from the same place; true if that left open what
  /// is near.
  bool entersEarlier(const Instances& instances, std::uint32_t segment, PrecisePoint ideal, PrecisePoint displacement);
  /// Whether no instance hits a blocking segment when the home instance moves straight from its position to `to`. Fast
  /// near the lattice path of the leg, after a call of `firstIdeal` for all instances.
  bool isFreeInLeg(const Instances& instances, Point to);
  /// Whether the regions, which `first` or `firstIdeal` has filled, contain warp segments.
  bool isNearWarps(const Instances& instances) const;
  /// The earliest hit, before `limit`, of any instance on a pierceable warp segment that has no instance behind it and
  /// is not in `refused`. Must follow calls of `firstIdeal` for the same path, whose regions it searches. Requires
  /// path.margin <= kRegionMargin.
  std::optional<LegHit> firstWarp(const Instances& instances, const Path& path, const std::optional<LegHit>& limit,
                                  const std::vector<WarpRef>& refused);
  /// Whether `shape` with `margin`, at the position of the placement, overlaps the segment of a pierceable warp that
  /// has no instance behind it.
  bool reachesWarp(const Instances& instances, const WarpRef& ref, const Convex& shape, std::int32_t margin);

  /// Whether no instance hits a blocking segment when the home instance moves straight from `from` to `to`.
  bool isFree(const Instances& instances, Point from, Point to);
  /// As above for one placement, in the frame of its part. With from == to, tests a position.
  bool isFree(const Placement& placement, Point from, Point to);
  /// Whether a segment may be in a box in the frame of the placement's part. Never false when one is.
  bool mayOverlap(const Placement& placement, const Box& box);
  /// The blocking segment of lowest index that overlaps `shape` at the position of the placement.
  std::optional<std::uint32_t> overlapped(const Placement& placement, const Convex& shape);
  /// Records the segments, in order of their indices, that the placement overlaps at its position.
  void recordOverlapped(const Placement& placement);

  /// Whether a blocking segment other than `ignored` comes within `distance` of `point`, along both axes of the
  /// placement's part.
  bool hasSegmentNear(const Placement& placement, Point point, std::int32_t distance, std::uint32_t ignored);

  /// Clips a path of one placement, in the frame of its part, against the obstacle of one segment.
  std::optional<Sweep::ClipInterval> clip(const Placement& placement, const Path& path, std::uint32_t segment);
  /// The collision of such a path with one segment.
  std::optional<Hit> hit(const Placement& placement, const Path& path, std::uint32_t segment);

  /// All segments recorded since `begin`, each once per instance: those that were pierced or overlapped.
  const std::vector<SegmentRef>& pierced() const { return pierced_; }
  /// The segments that the entity overlaps, in the order in which that began. They are pierced until they are removed
  /// from this list. Kept by step_contacts.cpp; always empty with Scope::kContacts.
  std::vector<SegmentRef>& overlapped() { return overlapped_; }

  /// A segment of a map part.
  struct PartSegment {
    std::uint32_t part;
    std::uint32_t index;
  };
  /// Whether what has blocked since `begin` depends on Rules::pierce.
  bool asksRules() const { return asksRules_; }
  /// The segments that have blocked since `begin` because Rules::mayPierce says so; some more than once.
  const std::vector<PartSegment>& solid() const { return solid_; }

  /// The reference that is passed to rules. Its toHome leads to the home part at the start of the step.
  SegmentRef refOf(const Placement& placement, std::uint32_t segment) const;
  /// Whether both are the same segment and the same instance.
  static bool isSame(const SegmentRef& a, const SegmentRef& b) {
    return a.instance == b.instance && a.index == b.index && a.part == b.part;
  }
  /// Whether one of `refs` is the same as `ref`.
  static bool contains(const std::vector<SegmentRef>& refs, const SegmentRef& ref);

 private:
  // An entry of the region of a placement.
  struct Near {
    std::size_t placement;
    std::size_t entry;
  };

  Region& start(const Placement& placement, const Convex& shape, Point from, Point to);
  Region& coveringRegion(const Placement& placement, const Box& box);
  bool isNearLeg(Point place) const;
  Region& regionOf(const Placement& placement) { return (*regions_)[placement.region]; }
  // Whether no later test can find an earlier hit or must record a pierceable segment.
  bool isFinal(const std::optional<LegHit>& best) const {
    return scope_ == Rules::Scope::kContacts && best && best->hit.time.numerator == 0;
  }
  std::optional<Sweep::ClipInterval> clip(const Placement& placement, Region& region, std::size_t entry);
  std::optional<std::size_t> startNear(const Placement& placement, const Path& path, std::uint32_t segment);
  // The number of entries, from the first, whose segments may block or are recorded.
  std::size_t checkedEntries(const Region& region) const {
    return scope_ == Rules::Scope::kEverything ? region.segments().size() : region.firstWarp();
  }
  bool blocks(const Placement& placement, std::uint32_t segment);
  void record(const SegmentRef& ref);
  bool blocksOrRecord(const Placement& placement, std::uint32_t segment);

  Rules* rules_ = nullptr;
  Rules::Scope scope_ = Rules::Scope::kEverything;  // of rules_
  std::optional<Entity> entity_;
  std::vector<Region>* regions_ = nullptr;
  Region::Work* work_ = nullptr;
  Angle angle_;  // of the shape, in the frame of the home part at the start of the step
  std::vector<SegmentRef> pierced_;
  std::vector<SegmentRef> overlapped_;
  bool asksRules_ = false;
  std::vector<PartSegment> solid_;
  Sweep sweep_;
  Path leg_{};              // lattice path of the home instance
  bool knowsNear_ = false;  // whether near_ is complete
  std::vector<Near> near_;  // the segments that are near the path of the leg, along which any instance moves
};

}  // namespace platon
