// For a C++ library without threads and folders, such as Debian's for WebAssembly: one recording at a time.

#include "tests/sim/sim_options.h"
#include "tests/sim/verify/verify_many.h"

namespace platon::sim {

bool isFolder(const std::string&) { return false; }

std::vector<std::string> recordingsAmong(const std::vector<std::string>&) {
  throw UsageError("this build of platon-sim verifies one recording at a time: platon-sim verify FILE");
}

VerifySummary verifyMany(const std::vector<std::string>&, unsigned, const std::function<void(const std::string&)>&,
                         const std::function<void(std::size_t)>&) {
  return {};
}

}  // namespace platon::sim
