#pragma once

#include <string>
#include <vector>

#include "platon/game/input.h"

namespace platon {

/// Reads a solution, one input a tick: lines of `ticks button…`, buttons being `wait`, `left`, `right`, `jump` and
/// `down`; `#` starts a comment. Throws std::runtime_error with file and line on anything else.
std::vector<Input> readSolution(const std::string& path);

}  // namespace platon
