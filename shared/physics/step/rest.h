#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "platon/physics/entity_state.h"
#include "platon/physics/rules.h"
#include "shared/physics/collider.h"
#include "shared/physics/step/step_events.h"

namespace platon {

/// Records a step, without rotation, that did not change its entity. While the state of the entity is the same, the
/// next step would have the same result, so it is replaced by repeating the events. Derived state; influences speed
/// only. Valid while the same segments block and no map part is added: so the step must not have asked Rules::pierce.
class Rest {
 public:
  /// Whether a step from this state, with these rules and their scope, was recorded as changing nothing.
  bool matches(const EntityState& state, std::span<const InstanceState> further, const Rules& rules,
               Rules::Scope scope) const {
    return known_ && scope == scope_ && state == state_ &&
           std::equal(further.begin(), further.end(), further_.begin(), further_.end()) &&
           (solid_.empty() || areSolid(rules));
  }
  /// Adds the events of the recorded step to `events`, as those of `entity`, and its instances to `further`.
  void repeat(StepEvents& events, EntityId entity, std::vector<InstanceState>& further) const;

  /// Records a step from `before` and `further` to `after` and `furtherAfter` with these events, if it changed nothing.
  /// Otherwise forgets the previous record. `collider` is that of the step.
  void record(const EntityState& before, std::span<const InstanceState> further, const EntityState& after,
              std::span<const InstanceState> furtherAfter, std::span<const StepEvents::Event> events,
              const Collider& collider);
  void forget() { known_ = false; }

 private:
  // Whether all that blocked in the step blocks with these rules, too.
  bool areSolid(const Rules& rules) const;

  bool known_ = false;
  Rules::Scope scope_ = Rules::Scope::kContacts;
  std::vector<Collider::PartSegment> solid_;  // with Scope::kSegments: what blocked
  EntityState state_;
  std::vector<InstanceState> further_;
  std::vector<StepEvents::Event> events_;
};

}  // namespace platon
