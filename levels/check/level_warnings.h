#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "platon/game/diagnostics.h"
#include "platon/game/level.h"

namespace platon {

/// What a valid level probably does not mean: a start from which the player falls for ever, a goal at a wall, doors
/// without key and plate, needed elements that it lacks, gaps that look wide enough for the ball and are not, and a
/// goal or lines that nobody can touch. In the order of the text. `stop` is asked every few milliseconds during the
/// search for lines that nobody can touch; when it returns true, warnings may be missing.
std::vector<Diagnostic> warningsOf(const std::shared_ptr<const Level>& level, const std::function<bool()>& stop = {});

// Parts of warningsOf.

/// Warns of gaps between two lines that look wide enough for the ball and are not: from kNarrowestGap units to the
/// width of the ball plus 3 subunits. Each line is named once, with the nearest such gap at one of its ends.
void warnOfNarrowGaps(const Level& level, Diagnostics& diagnostics);

/// Narrower gaps are seen to be closed.
inline constexpr double kNarrowestGap = 18;

/// Number of the lines of all faces.
std::size_t lineCount(const Level& level);

/// Warns of a goal that nobody can touch, whatever is pressed. `stop` as above.
void warnOfUntouchedGoal(const Level& level, Diagnostics& diagnostics, const std::function<bool()>& stop = {});

/// Warns of lines that nobody can touch, wherever doors are open: jumps are bounded by their height alone. So it warns
/// of no line that can be touched. When `stop` returns true, it warns of nothing.
void warnOfUntouchedLines(const Level& level, Diagnostics& diagnostics, const std::function<bool()>& stop = {});

}  // namespace platon
