#include "shared/game/state_difference.h"

#include <algorithm>
#include <map>
#include <utility>

namespace platon {
namespace {

using FieldKey = std::pair<std::string, std::string>;

template <class Integer>
std::string textOf(Integer value) {
  return std::to_string(+value);
}

std::string textOf(Point point) { return "(" + std::to_string(point.x) + ", " + std::to_string(point.y) + ")"; }

std::string textOf(Angle angle) { return std::to_string(angle.hundredths()); }

FieldKey keyOf(const StateField& field) { return {field.owner, field.name}; }

std::map<FieldKey, std::string> byKey(const std::vector<StateField>& fields) {
  std::map<FieldKey, std::string> values;
  for (const StateField& field : fields) values[keyOf(field)] = field.value;
  return values;
}

}  // namespace

std::vector<StateField> fieldsOf(const Game& game) {
  std::vector<StateField> fields;
  std::string owner = "game";
  const auto add = [&](const char* name, const auto& value) { fields.push_back({owner, name, textOf(value)}); };
  add("tick", game.tick());
  add("over", static_cast<int>(game.over()));
  add("slots", game.slots());
  for (std::uint32_t slot = 0; slot < game.slots(); ++slot) {
    const std::string entity = "entity " + std::to_string(slot);
    owner = entity;
    EntityState::visit(game.world().entities()[slot], add);
    const auto instances = game.world().instancesOf(slot);
    for (std::size_t i = 0; i < instances.size(); ++i) {
      owner = entity + " instance " + std::to_string(i + 1);
      InstanceState::visit(instances[i], add);
    }
    owner = "player " + std::to_string(slot);
    PlayerState::visit(game.player(slot), add);
  }
  return fields;
}

std::optional<StateDifference> firstDifference(const Game& left, const Game& right) {
  const auto here = fieldsOf(left);
  const auto there = fieldsOf(right);
  const auto valuesThere = byKey(there);
  for (const StateField& field : here) {
    const auto other = valuesThere.find(keyOf(field));
    if (other == valuesThere.end()) return StateDifference{field.owner, field.name, field.value, "nothing"};
    if (other->second != field.value) return StateDifference{field.owner, field.name, field.value, other->second};
  }
  const auto valuesHere = byKey(here);
  const auto extra = std::find_if(there.begin(), there.end(), [&](const StateField& field) {
    return !valuesHere.contains(keyOf(field));
  });
  if (extra == there.end()) return std::nullopt;
  return StateDifference{extra->owner, extra->name, "nothing", extra->value};
}

}  // namespace platon
