#pragma once

#include <string>

#include "tests/sim/verify/verification.h"

namespace platon::sim {

/// What is wrong with a recording, for people.
struct VerifyReport {
  std::string text;  ///< a sentence a line, each beginning with the path of the recording; empty when nothing is wrong
  int exitCode = 0;  ///< 1 for a divergence, else 3 for an incomplete recording
};

VerifyReport reportOf(const std::string& path, const Verification& found);
/// The value of the key "differs" of `verify --json`.
std::string jsonOf(const Divergence& divergence);
/// The keys "run" and "noRun" of `verify --json`, with their values.
std::string jsonOf(const std::variant<RunFinish, std::string>& run);
/// The line on the run.
std::string textOf(const std::variant<RunFinish, std::string>& run);

}  // namespace platon::sim
