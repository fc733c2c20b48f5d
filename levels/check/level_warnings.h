#pragma once

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

}  // namespace platon
