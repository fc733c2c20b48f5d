#pragma once

#include <cstdint>
#include <span>

#include "platon/physics/step_observer.h"

namespace platon::long_runs {

/// A world that is observed computes every step: it repeats none from its memory of bodies at rest.
class EveryStep : public StepObserver {
 public:
  void leg(std::uint32_t, std::span<const InstanceView>) override { ++calls; }

  std::int64_t calls = 0;
};

}  // namespace platon::long_runs
