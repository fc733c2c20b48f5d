#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <string>

#include "protocol/program_error.h"
#include "server/admin/console_socket.h"
#include "server/program/async_line_writer.h"
#include "server/program/command_line.h"
#include "server/program/config_check.h"
#include "server/program/options.h"
#include "server/program/server_program.h"

namespace platon {
namespace {

volatile std::sig_atomic_t stopRequested = 0;
volatile std::sig_atomic_t terminations = 0;
volatile std::sig_atomic_t reloadRequested = 0;

// Sets a signal handler without SA_RESTART, so that a signal ends the server's sleep.
void onSignal(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  sigaction(signal, &action, nullptr);
}

// The runtime of the thread sanitizer makes the signal state of a thread in its first blocking call, and loses a signal
// that interrupts it meanwhile (libsanitizer of GCC 12 and LLVM 14, SigCtx). So that call comes before the handlers.
void makeSanitizerSignalState() {
#ifdef __SANITIZE_THREAD__
  poll(nullptr, 0, 0);
#endif
}

int serve(const CommandLine& line) {
  AsyncLineWriter errors(STDERR_FILENO);
  ServerProgram program(line, [&errors](std::string_view text) { errors.write(text); });
  makeSanitizerSignalState();
  onSignal(SIGTERM, [](int) { terminations = terminations + 1; });
  onSignal(SIGINT, [](int) { stopRequested = 1; });
  onSignal(SIGHUP, [](int) { reloadRequested = 1; });
  program.announce();
  const bool kept = program.run([&, terminated = 0]() mutable {
    for (; terminated < terminations; ++terminated) program.terminate();
    if (reloadRequested != 0) {
      reloadRequested = 0;
      program.reload();
    }
    if (const std::uint64_t lines = errors.takeDropped()) {
      program.server().log().warning("log lines dropped", {{"lines", lines}});
    }
    return stopRequested != 0;
  });
  return kept ? 0 : ProgramError::kFailed;
}

int openConsole(const CommandLine& line) {
  const std::string socket = optionsOf(line).socket;
  const bool interactive = isatty(STDIN_FILENO) != 0;
  return runConsole(socket.empty() ? defaultConsolePath() : socket, {std::cin, std::cout, std::cerr, interactive});
}

int reportConfig(const CommandLine& line) {
  const ConfigCheck check = checkConfig(line);
  for (const std::string& error : check.errors) std::cerr << error << '\n';
  if (check.exitCode == 0) std::cout << check.summary << '\n';
  return check.exitCode;
}

int runTask(int argc, char** argv) {
  const auto line = readCommandLine(argc, argv);
  if (!line) return 0;
  switch (line->task) {
    case ServerTask::kServe:
      return serve(*line);
    case ServerTask::kConsole:
      return openConsole(*line);
    case ServerTask::kPrintConfig:
      std::cout << printedConfig();
      return 0;
    case ServerTask::kCheckConfig:
      return reportConfig(*line);
  }
  return ProgramError::kUsage;
}

int fail(int exitCode, const std::string& prefix, const char* what) {
  std::fprintf(stderr, "%s%s\n", prefix.c_str(), what);
  return exitCode;
}

}  // namespace
}  // namespace platon

int main(int argc, char** argv) {
  using platon::ProgramError;
  signal(SIGPIPE, SIG_IGN);  // an error message that nobody reads must not change the exit code
  signal(SIGXFSZ, SIG_IGN);  // a recording that has become too long must not end the match
  try {
    return platon::runTask(argc, argv);
  } catch (const ProgramError& error) {
    const bool level = error.exitCode() == ProgramError::kInvalid;
    return platon::fail(error.exitCode(), level ? "" : "platon-server: ", error.what());
  } catch (const std::exception& error) {
    return platon::fail(ProgramError::kFailed, "platon-server: ", error.what());
  }
}
