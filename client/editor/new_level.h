#pragma once

#include <string>

#include "platon/game/solid.h"

namespace platon {

/// The text of a new level: a floor, the start and the goal on face 0.
std::string newLevelText(SolidKind solid, const std::string& title);

/// A title made of the name of a level file: `02_half_turn.level` gives `Half turn`.
std::string titleOf(const std::string& fileName);

}  // namespace platon
