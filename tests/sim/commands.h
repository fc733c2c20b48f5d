#pragma once

#include <string>
#include <vector>

namespace platon::sim {

/// The commands of platon-sim. They write results to stdout, return the exit code, and throw UsageError or InputError.
int runCommand(const std::vector<std::string>& arguments);
int verifyCommand(const std::vector<std::string>& arguments);
int worldCommand(const std::vector<std::string>& arguments);
int sweepCommand(const std::vector<std::string>& arguments);

}  // namespace platon::sim
