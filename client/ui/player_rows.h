#pragma once

#include <string>
#include <vector>

#include "client/scene/scene.h"

namespace platon {

/// What a player is called: its name, or its number, `Player 3`, if it has none.
std::string calledName(const std::string& name, const std::string& number);

/// What lists call a player: the same, cut if it is long.
std::string shownNameOf(const PlayerDrawing& player);

/// A time to the goal: `12.34 s`. `seconds` ≥ 0.
std::string finishText(double seconds);

/// Players who have finished, by time; then the others, by slot. Valid as long as the scene.
std::vector<const PlayerDrawing*> inOrder(const Scene& scene);

}  // namespace platon
