#include <csignal>
#include <cstdio>
#include <exception>
#include <sstream>
#include <string>

#include "protocol/program_error.h"
#include "server/app/dedicated_server.h"
#include "server/app/level_files.h"
#include "server/app/server_options.h"

namespace platon {
namespace {

volatile std::sig_atomic_t stopAsked = 0;
volatile std::sig_atomic_t reloadAsked = 0;

// Without SA_RESTART, so that a sleeping server wakes up.
void onSignal(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  sigaction(signal, &action, nullptr);
}

ServerSettings settingsOf(const ServerOptions& options) {
  ServerSettings settings;
  settings.host.bind = options.bind;
  settings.host.port = options.port;
  settings.host.connectionsPerAddress = options.maxPerAddress;
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
    server.log().info(same ? "configuration and levels read again"
                           : "configuration and levels read again; address, port, numbers of players and recordings "
                             "change when the server is started anew");
  } catch (const ProgramError& error) {
    std::istringstream faults(error.what());
    for (std::string fault; std::getline(faults, fault);) server.log().warning(fault);
    server.log().warning("configuration and levels stay as they are");
  }
}

int serve(int argc, char** argv) {
  auto options = readOptions(argc, argv);
  if (!options) return 0;
  Log log(options->logFormat);
  DedicatedServer server(settingsOf(*options), levelsOf(*options, log), log);
  onSignal(SIGTERM, [](int) { stopAsked = 1; });
  onSignal(SIGINT, [](int) { stopAsked = 1; });
  onSignal(SIGHUP, [](int) { reloadAsked = 1; });
  server.log().info("listening on " + options->bind + ":" + std::to_string(server.port()));
  while (stopAsked == 0) {
    if (reloadAsked != 0) {
      reloadAsked = 0;
      reload(server, *options, argc, argv);
    }
    server.step(std::chrono::steady_clock::now());
    server.wait();
  }
  server.stop("the server stops");
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
  try {
    return platon::serve(argc, argv);
  } catch (const ProgramError& error) {
    const bool level = error.exitCode() == ProgramError::kLevel;
    return platon::fail(error.exitCode(), level ? "" : "platon-server: ", error.what());
  } catch (const platon::HostError& error) {
    return platon::fail(ProgramError::kUsage, "platon-server: ", error.what());
  } catch (const std::exception& error) {
    return platon::fail(ProgramError::kFailed, "platon-server: ", error.what());
  }
}
