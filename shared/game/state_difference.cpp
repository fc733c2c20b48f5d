#include "platon/game/state_difference.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

namespace platon {
namespace {

using FieldKey = std::pair<std::string, std::string>;  // owner and name

constexpr const char* kNothing = "nothing";

template <class Integer>
std::string textOf(Integer value) {
  return std::to_string(+value);
}

std::string textOf(Point point) { return "(" + std::to_string(point.x) + ", " + std::to_string(point.y) + ")"; }

std::string textOf(Angle angle) { return std::to_string(angle.centidegrees()); }

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

std::vector<StateDifference> compareFields(const Game& left, const Game& right) {
  std::vector<StateDifference> rows;
  std::map<FieldKey, std::size_t> places;
  for (StateField& field : fieldsOf(left)) {
    places[{field.owner, field.name}] = rows.size();
    rows.push_back({std::move(field.owner), std::move(field.name), std::move(field.value), kNothing});
  }
  for (StateField& field : fieldsOf(right)) {
    const auto place = places.find({field.owner, field.name});
    if (place == places.end())
      rows.push_back({std::move(field.owner), std::move(field.name), kNothing, std::move(field.value)});
    else
      rows[place->second].right = std::move(field.value);
  }
  return rows;
}

std::optional<StateDifference> firstDifference(const Game& left, const Game& right) {
  const auto rows = compareFields(left, right);
  const auto first = std::find_if(rows.begin(), rows.end(), [](const StateDifference& row) { return row.differs(); });
  return first == rows.end() ? std::nullopt : std::optional(*first);
}

}  // namespace platon
