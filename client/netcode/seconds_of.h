#pragma once

#include "platon/game/game.h"

namespace platon {

/// Seconds that so many ticks last.
constexpr double secondsOf(double ticks) { return ticks / kTicksPerSecond; }

}  // namespace platon
