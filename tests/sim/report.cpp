#include "tests/sim/report.h"

#include <cstdio>

#include "tests/sim/sim_options.h"

namespace platon::sim {

int report(const std::exception& reason) {
  if (dynamic_cast<const UsageError*>(&reason) != nullptr) {
    std::fprintf(stderr, "platon-sim: %s\n", reason.what());
    return 2;
  }
  if (*reason.what() != '\0') std::fprintf(stderr, "%s\n", reason.what());
  return 3;
}

}  // namespace platon::sim
