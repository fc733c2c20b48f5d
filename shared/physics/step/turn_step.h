#pragma once

#include <cstdint>
#include <optional>

#include "shared/physics/step/mover.h"
#include "shared/physics/step/step_contacts.h"

namespace platon {

/// The rotation stage of a step: rotates the shapes of all instances together, in portions.
class TurnStep {
 public:
  TurnStep(Mover& mover, StepContacts& contacts) : mover_(mover), contacts_(contacts) {}

  /// Rotates the entity by `centidegrees`, or as far as no segment blocks it.
  void turn(std::int32_t centidegrees);

 private:
  bool tryPortion(std::int32_t centidegrees);
  std::optional<SegmentRef> blocker(std::int32_t centidegrees, std::size_t from);
  bool insertInstances(std::int32_t centidegrees);

  Mover& mover_;
  StepContacts& contacts_;
};

}  // namespace platon
