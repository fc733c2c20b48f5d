#pragma once

#include <string>
#include <vector>

namespace platon::sim {

/// The commands of platon-sim. Each prints its result to stdout and returns the exit code. Throws UsageError or
/// InputError.
int runCommand(const std::vector<std::string>& arguments);
int verifyCommand(const std::vector<std::string>& arguments);
int worldCommand(const std::vector<std::string>& arguments);
int sweepCommand(const std::vector<std::string>& arguments);

}  // namespace platon::sim
