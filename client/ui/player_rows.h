#pragma once

#include <string>
#include <vector>

#include "client/scene/scene.h"

namespace platon {

/// What lists call a player: its name, cut if it is long, or its number.
std::string shownNameOf(const PlayerDrawing& player);

/// A time to the goal: `12.34 s`. `seconds` ≥ 0.
std::string finishText(double seconds);

/// Players who have finished, by time; then the others, by slot. Valid as long as the scene.
std::vector<const PlayerDrawing*> inOrder(const Scene& scene);

}  // namespace platon
