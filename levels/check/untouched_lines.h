#pragma once

#include "platon/game/diagnostics.h"
#include "platon/game/level.h"

namespace platon {

/// Warns of lines that nobody can touch, wherever doors are open: jumps are bounded by their height alone. So it warns
/// of no line that can be touched.
void warnOfUntouchedLines(const Level& level, Diagnostics& diagnostics);

}  // namespace platon
