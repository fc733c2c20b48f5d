#pragma once

#include <optional>
#include <string>
#include <vector>

#include "platon/game/game.h"

namespace platon {

/// One field of a game's state as text.
struct StateField {
  std::string owner;  ///< "game", "entity 3", "entity 3 instance 1" or "player 3"
  std::string name;
  std::string value;  ///< points as (x, y), angles in centidegrees

  friend bool operator==(const StateField&, const StateField&) = default;
};

/// Every field that is hashed and saved, in a fixed order.
std::vector<StateField> fieldsOf(const Game& game);

/// The values of one field in two games on the same level; "nothing" for a game without this field.
struct StateDifference {
  std::string owner;
  std::string field;
  std::string left;
  std::string right;

  bool differs() const { return left != right; }
};

/// Every field of either game: those of the left game in their order, then those that only the right game has.
std::vector<StateDifference> compareFields(const Game& left, const Game& right);

/// The first field in which the games differ; nothing when they are equal.
std::optional<StateDifference> firstDifference(const Game& left, const Game& right);

}  // namespace platon
