#pragma once

#include <cstdint>
#include <span>

#include "platon/exact/angle.h"
#include "platon/exact/point.h"

namespace platon {

/// The current placement of one instance of an entity.
struct InstanceView {
  std::uint16_t id = 0;
  std::uint32_t part = 0;
  Point position;  ///< subunits, in the frame of the part
  Angle angle;     ///< rotation of the shape in the frame of the part
  bool home = false;
  bool hasParent = false;    ///< false for the home instance and for those placed by MapPart::insert
  std::uint16_t parent = 0;  ///< id of the parent instance, when hasParent
  std::uint16_t warp = 0;    ///< index of the warp in the parent's part, when hasParent
};

/// Observes a step, for traces and checkers. The world may be read, and is as it was before the step; changing it
/// throws std::logic_error.
class StepObserver {
 public:
  virtual ~StepObserver() = default;
  /// Called with all instances of an entity, home first: at the start of its step, after every leg (a straight move of
  /// all instances) and after every other change of the instances.
  virtual void leg(std::uint32_t entity, std::span<const InstanceView> instances) = 0;
};

}  // namespace platon
