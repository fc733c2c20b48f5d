#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

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

Report run(const Effort& effort) {
  const StdoutToStderr quiet;
  return runAll(effort, [](const char* part) { std::fprintf(stderr, "platon-bench: %s\n", part); });
}

}  // namespace

int main(int argc, char** argv) {
  bool quick = false;
  bool json = false;
  platon::ProgramOptions program("platon-bench",
                                 "platon-bench: measures speed and error of Platon and of other engines.");
  program.addFlag("--quick", quick, "do a tenth of the work, in less than a minute");
  program.addFlag("--json", json, "print one JSON object");
  try {
    if (!program.read(argc, argv)) return 0;
    std::filesystem::current_path(PLATON_ROOT);  // paths of levels and scenes are relative to it
    const Report report = run(quick ? Effort::quick() : Effort());
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
