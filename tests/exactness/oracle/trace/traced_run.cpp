#include "tests/exactness/oracle/trace/traced_run.h"

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

#include "tests/exactness/oracle/trace/trace_checker.h"
#include "tests/support/process.h"

namespace platon::oracle {
namespace {

// Applies after the end of the trace.
constexpr std::chrono::seconds kRunLimit{60};

using Stream = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// Checks a trace up to its end, or up to a line after which it cannot be checked, and closes the descriptor.
void checkStream(int descriptor, TraceChecker& checker) {
  const Stream stream(fdopen(descriptor, "r"), &std::fclose);
  char* buffer = nullptr;
  std::size_t capacity = 0;
  bool going = true;
  for (ssize_t length = 0; going && (length = getline(&buffer, &capacity, stream.get())) > 0;) {
    const auto size = static_cast<std::size_t>(length);
    going = checker.checkLine({buffer, buffer[size - 1] == '\n' ? size - 1 : size});
  }
  std::free(buffer);
  checker.finish();
}

}  // namespace

TracedRun runTraced(std::vector<std::string> arguments) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  arguments.insert(arguments.end(), {"--trace", "/dev/fd/" + std::to_string(ends[1])});
  ProcessOptions options;
  options.captureOutput = false;
  options.inheritedDescriptor = ends[1];
  Process program(arguments, options);
  close(ends[1]);
  TraceChecker checker;
  checkStream(ends[0], checker);
  const int exitCode = program.wait(kRunLimit);
  return {checker.report(), exitCode};
}

}  // namespace platon::oracle
