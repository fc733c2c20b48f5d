#include "shared/physics/step/rest.h"

#include <algorithm>

namespace platon {

void Rest::repeat(StepEvents& events, EntityId entity, std::vector<InstanceState>& further) const {
  events.add(events_, entity);
  further.insert(further.end(), further_.begin(), further_.end());
}

bool Rest::areSolid(const Rules& rules) const {
  return std::none_of(solid_.begin(), solid_.end(), [&](const Collider::PartSegment& segment) {
    return rules.mayPierce(segment.part, segment.index);
  });
}

void Rest::record(const EntityState& before, std::span<const InstanceState> further, const EntityState& after,
                  std::span<const InstanceState> furtherAfter, std::span<const StepEvents::Event> events,
                  const Collider& collider) {
  known_ = !collider.asksRules() && before == after &&
           std::equal(further.begin(), further.end(), furtherAfter.begin(), furtherAfter.end());
  if (!known_) return;
  scope_ = collider.scope();
  solid_ = collider.solid();
  state_ = after;
  further_.assign(further.begin(), further.end());
  events_.assign(events.begin(), events.end());
}

}  // namespace platon
