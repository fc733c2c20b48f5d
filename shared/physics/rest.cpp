#include "shared/physics/rest.h"

#include <algorithm>

namespace platon {

void Rest::repeat(Entity entity, Rules& rules, std::vector<InstanceState>& further) const {
  for (const Contact& contact : contacts_) rules.contact(entity, contact);
  further.insert(further.end(), further_.begin(), further_.end());
}

void Rest::record(const EntityState& before, std::span<const InstanceState> further, const EntityState& after,
                  std::span<const InstanceState> furtherAfter, std::span<const Contact> contacts) {
  known_ = before.turn == 0 && before == after &&
           std::equal(further.begin(), further.end(), furtherAfter.begin(), furtherAfter.end());
  if (!known_) return;
  state_ = after;
  further_.assign(further.begin(), further.end());
  contacts_.assign(contacts.begin(), contacts.end());
}

}  // namespace platon
