#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "platon/physics/entity.h"
#include "platon/physics/entity_state.h"
#include "platon/physics/rules.h"

namespace platon {

/// A step without a turn that has left its entity exactly as it was. For as long as nothing about the entity changes,
/// another step would do the same: it is repeated by telling the rules of the same contacts. Derived: no result depends
/// on it, as long as lines block what they blocked before (`Rules::ignoresWarps`) and no map part is added.
class Rest {
 public:
  /// Whether a step of this entity has been seen to change nothing.
  bool isOf(const EntityState& state, std::span<const InstanceState> further) const {
    return known_ && state == state_ && std::equal(further.begin(), further.end(), further_.begin(), further_.end());
  }
  /// Calls what that step called and hands back its instances.
  void repeat(Entity entity, Rules& rules, std::vector<InstanceState>& further) const;

  /// A step led from `before` and `further` to `after` and `furtherAfter`, and met `contacts`.
  void take(const EntityState& before, std::span<const InstanceState> further, const EntityState& after,
            std::span<const InstanceState> furtherAfter, std::span<const Contact> contacts);
  void forget() { known_ = false; }

 private:
  bool known_ = false;
  EntityState state_;
  std::vector<InstanceState> further_;
  std::vector<Contact> contacts_;
};

}  // namespace platon
