#pragma once

#include <string>
#include <vector>

namespace platon {

/// Checks level files: every error and warning goes to stderr as `file:line:column: error: …`, the result to stdout,
/// with `json` as one JSON object. Returns the exit code: 0, 3 when a level has an error, 2 when a file cannot be read.
int checkLevels(const std::vector<std::string>& files, bool json);

}  // namespace platon
