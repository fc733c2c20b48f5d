#pragma once

#include "platon/game/diagnostics.h"
#include "platon/game/level.h"

namespace platon {

/// Warns of gaps between two lines that look wide enough for the ball and are not: from kNarrowest units to the width
/// of the ball plus 3 subunits. Each line is named once, with the nearest such gap at one of its ends.
void warnOfNarrowGaps(const Level& level, Diagnostics& diagnostics);

/// Narrower gaps are seen to be closed.
inline constexpr double kNarrowestGap = 18;

}  // namespace platon
