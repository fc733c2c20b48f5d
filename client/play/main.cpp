#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/files/settings_file.h"
#include "client/files/user_folders.h"
#include "client/lobby/listed_servers.h"
#include "client/lobby/near_servers.h"
#include "client/lobby/shipped_levels.h"
#include "client/play/client_options.h"
#include "client/play/edit_play.h"
#include "client/play/match/embedded_server.h"
#include "client/play/offscreen/frame_benchmark.h"
#include "client/play/offscreen/frame_play.h"
#include "client/play/offscreen/offscreen_play.h"
#include "client/play/offscreen/offscreen_replay.h"
#include "client/play/window_play.h"
#include "client/time/steady_now.h"
#include "protocol/program_error.h"
#include "server/app/level_files.h"

namespace platon {
namespace {

// Set by a signal, which may arrive in any thread.
std::atomic<bool> stopSignal = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler must not wait for a lock");

bool stopRequested() { return stopSignal; }

EmbeddedSettings ownLevels(const ClientOptions& options) {
  EmbeddedSettings settings;
  if (!options.level.empty()) settings.levels = {options.level};
  return settings;
}

void benchmark(const ClientOptions& options) {
  const std::vector<std::string> files =
      options.level.empty() ? gameLevelFiles() : std::vector<std::string>{options.level};
  const std::shared_ptr<const Level> level = loadLevelFiles({files.front()}).levels.front();
  const BenchmarkReport report = FrameBenchmark(level, {steadyClock().now, programTime, threadTime}).run(stopRequested);
  std::fputs((options.json ? toJson(report) : toText(report)).c_str(), stdout);
}

// One search; a server in the same network answers within milliseconds.
void listNearServers(const Clock& clock) {
  NearServers servers = searchNearby();
  for (const Moment end = clock.now() + std::chrono::seconds(1); clock.now() < end && !stopRequested();) {
    servers.update(clock.now());
    servers.socket().wait(std::chrono::milliseconds(20));
  }
  servers.update(clock.now());
  if (servers.list().empty())
    std::fputs("platon-client: no server nearby answers; ask who runs one for its address\n", stderr);
  std::fputs(textOf(servers.list()).c_str(), stdout);
}

// Returns the exit code: 1 if the list could not be read as a whole.
int printListedServers(const std::string& url, const Clock& clock) {
  ListedServers servers(url);
  for (Moment end = clock.now() + std::chrono::seconds(1); clock.now() < end && !stopRequested();) {
    servers.update(clock.now());
    if (servers.reading()) end = clock.now() + std::chrono::seconds(1);
    servers.wait(std::chrono::milliseconds(20));
  }
  servers.update(clock.now());
  for (const std::string& fault : servers.faults()) std::fprintf(stderr, "platon-client: %s\n", fault.c_str());
  if (servers.list().empty() && servers.faults().empty())
    std::fputs("platon-client: no server of the list answers\n", stderr);
  std::fputs(textOf(servers.list()).c_str(), stdout);
  return servers.faults().empty() ? 0 : 1;
}

int listServers(const ClientOptions& options, const Clock& clock) {
  if (!options.listUrl.empty()) return printListedServers(options.listUrl, clock);
  listNearServers(clock);
  return 0;
}

int play(int argc, char** argv) {
  std::optional<ClientOptions> options = readClientOptions(argc, argv);
  if (!options) return 0;
  std::signal(SIGTERM, [](int) { stopSignal = true; });
  std::signal(SIGINT, [](int) { stopSignal = true; });
  if (!options->frames.folder.empty()) {
    FramePlay(*options, loadLevelFiles({options->level}).levels.front()).run(stopRequested);
    return 0;
  }
  if (options->list) return listServers(*options, steadyClock());
  if (options->benchmark) {
    benchmark(*options);
    return 0;
  }
  if (!options->edit.empty()) {
    EditPlay(*options, steadyClock()).run(stopRequested);
    return 0;
  }
  if (options->offscreen && !options->replay.empty()) {
    OffscreenReplay(*options, SettingsFile(configFolder()).load(), steadyClock(), stopRequested).run();
    return 0;
  }
  if (!options->offscreen) {
    WindowPlay(*options, steadyClock()).run(stopRequested);
    return 0;
  }
  std::optional<EmbeddedServer> embedded;
  if (!options->server) embedded.emplace(ownLevels(*options));
  if (embedded) options->knowledge.identity = embedded->identity();
  const ServerAddress server = embedded ? embedded->address() : *options->server;
  OffscreenPlay(*options, server, steadyClock()).run(stopRequested);
  return 0;
}

int fail(int exitCode, const char* prefix, const char* what) {
  std::fprintf(stderr, "%s%s\n", prefix, what);
  return exitCode;
}

}  // namespace
}  // namespace platon

int main(int argc, char** argv) {
  using platon::ProgramError;
  try {
    return platon::play(argc, argv);
  } catch (const ProgramError& error) {
    const bool level = error.exitCode() == ProgramError::kInvalid;
    return platon::fail(error.exitCode(), level ? "" : "platon-client: ", error.what());
  } catch (const std::exception& error) {
    return platon::fail(ProgramError::kFailed, "platon-client: ", error.what());
  }
}
