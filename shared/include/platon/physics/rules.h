#pragma once

#include <cstdint>

#include "platon/exact/fraction.h"
#include "platon/exact/point.h"
#include "platon/physics/entity.h"
#include "platon/physics/segment.h"

namespace platon {

/// A line as rules see it.
struct SegmentRef {
  std::uint32_t part = 0;   ///< id of the map part
  std::uint32_t index = 0;  ///< in the order in which the part's lines were added, warps after all others
  bool warp = false;
  Segment ends;
};

/// A mover stopped by a line.
struct Contact {
  SegmentRef segment;
  std::uint16_t instance = 0;  ///< id of the entity's instance that met the line
  Point point;                 ///< where they touch, in the line's part, to the nearest subunit
  Point normal;                ///< exact, pointing from the line to the mover, in the line's part
  Angle toHome;                ///< what is added to an angle in the line's part to get it in the home part
  Fraction time;               ///< of the leg
};

/// What the world does on collision events. `solve` calls each once per event, in the order of time within the step;
/// at equal times home comes before other instances, and these by age; then lines by index.
class Rules {
 public:
  virtual ~Rules() = default;

  /// Whether the entity passes through the line. Asked for lines in its path only; must depend on nothing but state
  /// and arguments.
  virtual bool pierce(const Entity& entity, const SegmentRef& line) const;

  /// True promises that `pierce` is the one above, which lets pass through warps alone, and that the next three do
  /// nothing. None of these is called then, and warps cost no sweep except where an instance is to come into being.
  virtual bool ignoresWarps() const { return false; }

  /// A pierceable line is met, still overlapped at the end of the step, left.
  virtual void beginContact(Entity& entity, const SegmentRef& line);
  virtual void overContact(Entity& entity, const SegmentRef& line);
  virtual void endContact(Entity& entity, const SegmentRef& line);

  /// A blocking line stops the entity; what is left of the displacement slides along it.
  virtual void contact(Entity& entity, const Contact& contact);
  /// A blocking line stops the entity from turning.
  virtual void touchContact(Entity& entity, const SegmentRef& line);
};

}  // namespace platon
