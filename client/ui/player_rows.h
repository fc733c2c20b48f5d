#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "client/scene/scene.h"

namespace platon {

/// What a player is called: its name, or its number, `Player 3`, if it has none.
std::string calledName(const std::string& name, const std::string& number);

/// What lists call a player: the same, cut if it is long.
std::string shownNameOf(const PlayerDrawing& player);

/// A part of a time: `07`. `value`: 0 … 99.
std::string twoDigits(long value);

/// A time to the goal: `12.34 s`. `seconds` ≥ 0.
std::string finishText(double seconds);
/// The same of a time in ticks.
std::string finishTextOf(std::uint32_t ticks);

/// How long the connection of a player is: `24 ms`; `over 1 s` for more than a second; empty if that is not known.
std::string roundTripText(const PlayerDrawing& player);
/// The part of the width of a list that it takes: 0 if it is known of nobody.
float roundTripWidth(const Scene& scene);

/// Players who have finished, by time; then the others, by slot. Valid as long as the scene.
std::vector<const PlayerDrawing*> inOrder(const Scene& scene);

}  // namespace platon
