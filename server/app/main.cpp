#include <signal.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <sstream>
#include <string>

#include "protocol/program_error.h"
#include "protocol/transport/udp_socket.h"
#include "server/app/async_line_writer.h"
#include "server/app/dedicated_server.h"
#include "server/app/identity_file.h"
#include "server/app/level_files.h"
#include "server/app/server_options.h"

namespace platon {
namespace {

volatile std::sig_atomic_t stopRequested = 0;
volatile std::sig_atomic_t reloadRequested = 0;

// Sets a signal handler without SA_RESTART, so that a signal ends the server's sleep.
void onSignal(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  sigaction(signal, &action, nullptr);
}

ServerSettings settingsOf(const ServerOptions& options) {
  ServerSettings settings;
  settings.bind = options.bind;
  settings.port = options.port;
  settings.playersPerAddress = options.maxPerAddress;
  settings.match.maxPlayers = options.maxPlayers;
  settings.match.serverName = options.name;
  settings.recordings = options.record;
  return settings;
}

std::vector<LevelPointer> levelsOf(const ServerOptions& options, Log& log) {
  LoadedLevels loaded = loadLevelFiles(options.levels.empty() ? shippedLevelFiles() : options.levels);
  for (const std::string& warning : loaded.warnings) log.warning(warning);
  return std::move(loaded.levels);
}

void reload(DedicatedServer& server, ServerOptions& options, int argc, char** argv) {
  try {
    const ServerOptions fresh = *readOptions(argc, argv);
    server.setLevels(levelsOf(fresh, server.log()));
    server.setName(fresh.name);
    server.log().setFormat(fresh.logFormat);
    const bool same = fresh.bind == options.bind && fresh.port == options.port &&
                      fresh.maxPlayers == options.maxPlayers && fresh.maxPerAddress == options.maxPerAddress &&
                      fresh.record == options.record;
    server.log().info(same ? "configuration and levels reloaded"
                           : "configuration and levels reloaded; restart the server to change address, port, player "
                             "limits and recordings");
  } catch (const ProgramError& error) {
    std::istringstream errors(error.what());
    for (std::string line; std::getline(errors, line);) server.log().warning(line);
    server.log().warning("configuration and levels not reloaded");
  }
}

int serve(int argc, char** argv) {
  auto options = readOptions(argc, argv);
  if (!options) return 0;
  AsyncLineWriter errors(STDERR_FILENO);
  Log log(options->logFormat, [&errors](std::string_view line) { errors.write(line); });
  ServerSettings settings = settingsOf(*options);
  settings.identity = loadIdentity("", log);
  DedicatedServer server(settings, levelsOf(*options, log), log);
  onSignal(SIGTERM, [](int) { stopRequested = 1; });
  onSignal(SIGINT, [](int) { stopRequested = 1; });
  onSignal(SIGHUP, [](int) { reloadRequested = 1; });
  server.log().info("listening on " + server.address().text());
  server.run([&] {
    if (reloadRequested != 0) {
      reloadRequested = 0;
      reload(server, *options, argc, argv);
    }
    if (const std::uint64_t lines = errors.takeDropped()) server.log().warning("log lines dropped", {{"lines", lines}});
    return stopRequested != 0;
  });
  return 0;
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
  try {
    return platon::serve(argc, argv);
  } catch (const ProgramError& error) {
    const bool level = error.exitCode() == ProgramError::kLevel;
    return platon::fail(error.exitCode(), level ? "" : "platon-server: ", error.what());
  } catch (const platon::SocketError& error) {
    return platon::fail(ProgramError::kUsage, "platon-server: ", error.what());
  } catch (const std::exception& error) {
    return platon::fail(ProgramError::kFailed, "platon-server: ", error.what());
  }
}
