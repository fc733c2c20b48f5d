#include "tests/sim/report.h"

#include <cstdio>

#include "tests/sim/sim_options.h"

namespace platon::sim {

int report(const std::exception& error) {
  if (dynamic_cast<const UsageError*>(&error) != nullptr) {
    std::fprintf(stderr, "platon-sim: %s\n", error.what());
    return 2;
  }
  if (*error.what() != '\0') std::fprintf(stderr, "%s\n", error.what());
  return 3;
}

}  // namespace platon::sim
