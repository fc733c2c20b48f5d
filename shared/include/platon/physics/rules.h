#pragma once

#include <cstdint>

#include "platon/exact/fraction.h"
#include "platon/exact/point.h"
#include "platon/physics/entity.h"
#include "platon/physics/segment.h"

namespace platon {

/// A segment of a map part, as passed to rules.
struct SegmentRef {
  std::uint32_t part = 0;   ///< id of the map part
  std::uint32_t index = 0;  ///< order of MapPart::line calls, followed by the warps in order of MapPart::warp calls
  bool warp = false;        ///< whether the segment belongs to a warp
  Segment ends;             ///< in the frame of the part
};

/// A collision of an entity with a blocking segment.
struct Contact {
  SegmentRef segment;
  std::uint16_t instance = 0;  ///< id of the instance that hit the segment
  Point point;                 ///< point of contact in the frame of the segment's part, to the nearest subunit
  Point normal;                ///< exact direction from the segment to the entity, in the frame of the segment's part
  Angle toHome;                ///< added to an angle in the segment's part, gives the angle in the home part
  Fraction time;               ///< fraction of the leg, in [0, 1)
};

/// Decides which segments block and receives collision events. World::solve calls each method once per event, ordered
/// by time within the step. Events at equal times are ordered by instance (home first, then by age), then by segment
/// index.
class Rules {
 public:
  virtual ~Rules() = default;

  /// Whether the entity passes through the segment. Called for segments near its path only. The result must depend only
  /// on the state of the world and the arguments. Default: warps can be passed, other segments block.
  virtual bool pierce(const Entity& entity, const SegmentRef& segment) const;

  /// Return true to promise that `pierce` is not overridden and that beginContact, overContact and endContact do
  /// nothing. None of the four is called then, which saves the tests against warps.
  virtual bool ignoresWarps() const { return false; }

  /// The entity begins to overlap a pierceable segment.
  virtual void beginContact(Entity& entity, const SegmentRef& segment);
  /// The entity overlaps a pierceable segment at the end of the step.
  virtual void overContact(Entity& entity, const SegmentRef& segment);
  /// The entity no longer overlaps a pierceable segment.
  virtual void endContact(Entity& entity, const SegmentRef& segment);

  /// A blocking segment stops the entity. The remaining displacement slides along the segment.
  virtual void contact(Entity& entity, const Contact& contact);
  /// A blocking segment stops the rotation of the entity.
  virtual void touchContact(Entity& entity, const SegmentRef& segment);
};

}  // namespace platon
