#pragma once

#include <memory>
#include <optional>

#include "levels/solve/solution.h"

namespace platon {

/// For how many ticks the tightest jump of a solution may be pressed: the player runs on or waits as before the jump,
/// jumps some ticks earlier or later, holds the same buttons as in the solution, and comes to stand where it did there.
/// At most 2 * kMaxSlack + 1. Nothing when no player jumps.
std::optional<int> tightestJump(const std::shared_ptr<const Level>& level, const Solution& solution);

/// Most ticks by which a jump is tried earlier and later.
inline constexpr int kMaxSlack = 15;

}  // namespace platon
