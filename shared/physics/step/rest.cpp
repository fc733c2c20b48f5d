#include "shared/physics/step/rest.h"

#include <algorithm>

namespace platon {

void Rest::repeat(StepEvents& events, EntityId entity, std::vector<InstanceState>& further) const {
  events.add(events_, entity);
  further.insert(further.end(), further_.begin(), further_.end());
}

void Rest::record(const EntityState& before, std::span<const InstanceState> further, const EntityState& after,
                  std::span<const InstanceState> furtherAfter, std::span<const StepEvents::Event> events) {
  known_ = before == after && std::equal(further.begin(), further.end(), furtherAfter.begin(), furtherAfter.end());
  if (!known_) return;
  state_ = after;
  further_.assign(further.begin(), further.end());
  events_.assign(events.begin(), events.end());
}

}  // namespace platon
