#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "platon/game/element.h"

namespace platon {

/// Options of `platon-level solve`.
struct SolveOptions {
  std::string file;
  std::string recording;               ///< file to write; empty: none
  std::string recorded;                ///< recording to tell about instead of a search; empty: search
  std::optional<int> withoutCrossing;  ///< prove that there is no way with fewer crossings
  std::optional<ElementWord> without;  ///< prove that there is no way that uses none of these elements
  std::uint32_t pressCost = 0;         ///< of each press of a button, in ticks: the higher, the fewer presses
  bool json = false;
};

/// Searches for a way to the goal, tells about a recorded one, or proves that every way needs its crossings, or some
/// elements. Returns the exit code.
int solveLevel(const SolveOptions& options);

}  // namespace platon
