#include "tests/exactness/oracle/trace/traced_run.h"

#include <cerrno>
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

using Stream = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// Reads to the end, or to where the trace cannot be judged any longer, and closes.
void checkStream(int descriptor, TraceChecker& checker) {
  const Stream stream(fdopen(descriptor, "r"), &std::fclose);
  char* buffer = nullptr;
  std::size_t capacity = 0;
  bool going = true;
  for (ssize_t length = 0; going && (length = getline(&buffer, &capacity, stream.get())) > 0;) {
    const auto size = static_cast<std::size_t>(length);
    going = checker.take({buffer, buffer[size - 1] == '\n' ? size - 1 : size});
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
  const int exitCode = program.wait();
  return {checker.report(), exitCode};
}

}  // namespace platon::oracle
