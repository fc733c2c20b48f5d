#pragma once

#include <optional>
#include <string>

#include "platon/game/level.h"

namespace platon {

/// Returns the content of a level file, at most kMaxLevelBytes + 1 bytes of it. Returns nothing and sets `fault` when
/// the file cannot be read.
std::optional<std::string> readLevelFile(const std::string& path, std::string& fault);

/// Loads a level file and prints its errors and warnings to stderr, each as `file:line:column: error: …`. Returns
/// nothing, and prints why, when the file cannot be read.
std::optional<LevelResult> loadLevelFile(const std::string& path);

}  // namespace platon
