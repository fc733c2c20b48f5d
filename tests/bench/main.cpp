#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

#include <dlfcn.h>
#include <unistd.h>

#include "protocol/program_error.h"
#include "protocol/program_options.h"
#include "tests/bench/report.h"

namespace {

using namespace platon::bench;

// Redirects stdout to stderr while it exists: Debian's Chipmunk prints a greeting, and stdout is for results.
class StdoutToStderr {
 public:
  StdoutToStderr() : stdout_(dup(STDOUT_FILENO)) { dup2(STDERR_FILENO, STDOUT_FILENO); }
  ~StdoutToStderr() {
    std::fflush(stdout);
    dup2(stdout_, STDOUT_FILENO);
    close(stdout_);
  }
  StdoutToStderr(const StdoutToStderr&) = delete;
  StdoutToStderr& operator=(const StdoutToStderr&) = delete;

 private:
  int stdout_;
};

// The engine in a module that tests/bench/box2d3 has built. The module stays loaded.
const EngineKind* engineOf(const std::string& module) {
  void* const loaded = dlopen(module.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* const kind = loaded == nullptr ? nullptr : dlsym(loaded, "platonBenchEngine");
  if (kind == nullptr) {
    throw platon::ProgramError(platon::ProgramError::kUsage, "--engine: " + std::string(dlerror()) +
                                                                 "; ./platon bench builds a module if PLATON_BOX2D3 "
                                                                 "names a checkout of Box2D 3");
  }
  return static_cast<const EngineKind*>(kind);
}

Report run(const Effort& effort) {
  const StdoutToStderr quiet;
  return runAll(effort, [](const char* part) { std::fprintf(stderr, "platon-bench: %s\n", part); });
}

}  // namespace

int main(int argc, char** argv) {
  bool quick = false;
  bool json = false;
  std::string module;
  platon::ProgramOptions program("platon-bench",
                                 "platon-bench: measures speed and error of Platon and of other engines.");
  program.addFlag("--quick", quick, "do a tenth of the work, in less than a minute");
  program.addFlag("--json", json, "print one JSON object");
  program.add("--engine", module, "also measure the engine in this module");
  try {
    if (!program.read(argc, argv)) return 0;
    std::filesystem::current_path(PLATON_ROOT);  // paths of levels and scenes are relative to it
    Effort effort = quick ? Effort::quick() : Effort();
    if (!module.empty()) effort.guest = engineOf(module);
    const Report report = run(effort);
    std::printf("%s\n", (json ? toJson(report) : toText(report)).c_str());
    return 0;
  } catch (const platon::ProgramError& reason) {
    std::fprintf(stderr, "platon-bench: %s\n", reason.what());
    return reason.exitCode();
  } catch (const std::exception& reason) {
    std::fprintf(stderr, "platon-bench: %s\n", reason.what());
    return 1;
  }
}
