#include "tests/sim/report.h"

#include <cstdio>

#include "protocol/program_error.h"
#include "tests/sim/sim_options.h"

namespace platon::sim {

int report(const std::exception& error) {
  if (dynamic_cast<const UsageError*>(&error) != nullptr) {
    std::fprintf(stderr, "platon-sim: %s\n", error.what());
    return ProgramError::kUsage;
  }
  if (*error.what() != '\0') std::fprintf(stderr, "%s\n", error.what());
  return ProgramError::kInvalid;
}

}  // namespace platon::sim
