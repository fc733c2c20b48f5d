#pragma once

#include <cstdint>
#include <span>

#include "platon/exact/angle.h"
#include "platon/exact/point.h"

namespace platon {

/// One instance of an entity as it stands.
struct InstanceView {
  std::uint16_t id = 0;
  std::uint32_t part = 0;
  Point position;  ///< subunits, in the part's frame
  Angle angle;
  bool home = false;
  bool hasParent = false;    ///< on `parent` through `warp`; else home or placed by hand
  std::uint16_t parent = 0;  ///< id of another instance
  std::uint16_t warp = 0;    ///< index among the warps of the parent's part
};

/// Is told where an entity's instances stand at the start of a step, after every leg, and before and after home
/// passes. For traces and checkers; must not touch the world.
class StepObserver {
 public:
  virtual ~StepObserver() = default;
  virtual void leg(std::uint32_t entity, std::span<const InstanceView> instances) = 0;
};

}  // namespace platon
