#pragma once

#include <string>
#include <vector>

namespace platon {

/// Checks level files. Prints every error and warning to stderr as `file:line:column: error: …`, and the result to
/// stdout: a line per file, or one JSON object with `json`. Returns the exit code: 0, 2 when a file cannot be read, 3
/// when a level has an error.
int checkLevels(const std::vector<std::string>& files, bool json);

}  // namespace platon
