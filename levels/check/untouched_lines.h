#pragma once

#include <cstddef>
#include <functional>

#include "platon/game/diagnostics.h"
#include "platon/game/level.h"

namespace platon {

/// Number of the lines of all faces.
std::size_t lineCount(const Level& level);

/// Warns of a goal that nobody can touch, whatever is pressed. `stop` as below.
void warnOfUntouchedGoal(const Level& level, Diagnostics& diagnostics, const std::function<bool()>& stop = {});

/// Warns of lines that nobody can touch, wherever doors are open: jumps are bounded by their height alone. So it warns
/// of no line that can be touched. `stop` is asked every few milliseconds; when it returns true, it warns of nothing.
void warnOfUntouchedLines(const Level& level, Diagnostics& diagnostics, const std::function<bool()>& stop = {});

}  // namespace platon
