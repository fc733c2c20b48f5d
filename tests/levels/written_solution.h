#pragma once

#include <string>
#include <vector>

#include "platon/game/input.h"

namespace platon {

/// Reads the solution of a level: one input per tick. A line is `ticks button…` with the buttons `wait`, `left`,
/// `right`, `jump` and `down`; `#` starts a comment. Throws std::runtime_error with file and line on an invalid line.
std::vector<Input> readSolution(const std::string& path);

}  // namespace platon
