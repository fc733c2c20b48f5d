#include "client/play/match/embedded_server.h"

#include <atomic>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <mutex>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "client/files/user_folders.h"
#include "client/lobby/shipped_levels.h"
#include "protocol/files/file_watch.h"
#include "protocol/label.h"
#include "protocol/limits.h"
#include "protocol/program_error.h"
#include "protocol/transport/udp_socket.h"
#include "protocol/work/worker.h"
#include "server/app/dedicated_server.h"
#include "server/app/identity_file.h"
#include "server/app/level_files.h"

namespace platon {

namespace {

constexpr const char* kLoopback = "127.0.0.1";
constexpr const char* kAllAddresses = "::";
constexpr const char* kStopReason = "the server stops";

// The levels that come with the game; none if they cannot be read.
std::vector<LevelPointer> levelsOfTheGame() {
  try {
    return loadLevelFiles(gameLevelFiles()).levels;
  } catch (const ProgramError&) {
    return {};
  }
}

// Hashes can be forged: such a level would take over the times and runs of a level of the game.
void refuseForged(const std::vector<std::string>& files, const std::vector<LevelPointer>& levels) {
  for (const LevelPointer& ours : levelsOfTheGame()) {
    for (std::size_t i = 0; i < levels.size(); ++i) {
      if (levels[i]->hash == ours->hash && levels[i]->text != ours->text)
        throw ProgramError(ProgramError::kInvalid,
                           files[i] + ": error: has the same hash as a level of the game; change its text");
    }
  }
}

std::vector<LevelPointer> load(const std::vector<std::string>& files) {
  LoadedLevels loaded = loadLevelFiles(files);
  refuseForged(files, loaded.levels);
  for (const std::string& warning : loaded.warnings) std::fprintf(stderr, "%s\n", warning.c_str());
  return std::move(loaded.levels);
}

// Where the server keeps best times. Without a folder for them, they end with the server.
std::string keptBestTimes() {
  const std::filesystem::path file = bestTimesFile();
  if (file.empty()) return {};
  std::error_code fault;
  std::filesystem::create_directories(file.parent_path(), fault);
  return fault ? std::string() : file.string();
}

// The messages are for the operator of a server; a player needs none of them.
Log silentLog() {
  return Log(LogFormat::kText, [](std::string_view) {});
}

ServerSettings serverSettings(const EmbeddedSettings& wanted) {
  ServerSettings settings;
  settings.bestTimes = keptBestTimes();
  settings.bind = wanted.listens ? kAllAddresses : kLoopback;
  settings.port = wanted.listens ? wanted.port : 0;
  settings.password = wanted.password;
  settings.start = LevelRotation::Start::kFirst;  // the player has chosen it
  settings.match.serverName = "Platon";
  settings.match.maxPlayers = wanted.maxPlayers;
  settings.match.waitsForOne = wanted.waitsForOne;
  settings.match.keepsTimesOfOne = true;
  Log log = silentLog();
  if (wanted.listens) settings.identity = loadIdentity("", log);
  return settings;
}

std::function<TimePoint()> nowOf(const std::shared_ptr<const PausableClock>& clock) {
  if (!clock) return steadyNow;
  return [clock] { return TimePoint(clock->now()); };
}

// A player chooses the port on a page, not by an option.
std::string listenFault(const EmbeddedSettings& settings, const SocketError& error) {
  constexpr std::uint16_t kFirstFree = 1024;
  const std::string port = "UDP port " + std::to_string(settings.port);
  if (settings.listens && error.exitCode() == SocketError::kFailed)
    return "Another program uses " + port + ": choose another port.";
  if (settings.listens && settings.port < kFirstFree)
    return "The game may not use " + port + ": choose a port above 1023.";
  return error.what();
}

// The first line of an error in a level file, as a notice for the player, who knows which file it is.
std::string noticeOf(const std::string& file, const std::string& error) {
  std::string text = error.substr(0, error.find('\n'));
  if (text.starts_with(file + ":")) text.erase(0, file.size() + 1);
  text = ("level not reloaded: " + text).substr(0, kMaxReasonBytes);
  while (!isLabel(text, kMaxReasonBytes)) text.pop_back();
  return text;
}

}  // namespace

struct EmbeddedServer::Running {
  Running(const EmbeddedSettings& settings, const std::vector<std::string>& files,
          const std::shared_ptr<const PausableClock>& clock)
      : now(nowOf(clock)), levelFiles(files), server(serverSettings(settings), load(files), silentLog(), now()) {
    server.setClock(now);
    if (!settings.stepped) thread = startThread([this] { run(); });
  }
  ~Running() {
    stop = true;
    thread.joinable() ? thread.join() : server.stop(kStopReason);
  }

  void run() {
    while (!stop) {
      step();
      server.wait();
    }
    server.stop(kStopReason);
  }

  void step() {
    if (levelFiles.poll(std::chrono::steady_clock::now())) reload();
    server.match().countTimes(timesCount);
    {
      const std::lock_guard lock(keptMutex);
      server.match().keepTimesOf(kept);
    }
    if (nextAsked.exchange(false)) server.match().startNextRound();
    server.step(now());
    clients = server.match().clients();
    waits = server.match().waits();
  }

  // Whoever plays the only level while it is made sees each version at once.
  void reload() {
    try {
      server.updateLevels(load(levelFiles.files()));
      if (levelFiles.files().size() == 1) server.match().startNextRound();
    } catch (const ProgramError& error) {
      std::fprintf(stderr, "%s\n", error.what());
      server.match().say(noticeOf(levelFiles.files().front(), error.what()));
    }
  }

  std::function<TimePoint()> now;
  FileWatch levelFiles;
  DedicatedServer server;
  std::atomic<bool> stop{false};
  std::atomic<bool> nextAsked{false};
  std::atomic<bool> timesCount{true};
  std::mutex keptMutex;
  SlotsByLocal kept;  // nobody's at first
  std::atomic<std::size_t> clients{0};
  std::atomic<bool> waits{false};
  std::thread thread;  // last: uses the members above from its start; not joinable: there is none
};

EmbeddedServer::EmbeddedServer(const EmbeddedSettings& settings, const std::shared_ptr<const PausableClock>& clock) {
  try {
    running_ = std::make_unique<Running>(settings, settings.levels.empty() ? gameLevelFiles() : settings.levels, clock);
  } catch (const SocketError& error) {
    throw ProgramError(ProgramError::kFailed, listenFault(settings, error));
  }
}

EmbeddedServer::~EmbeddedServer() = default;

void EmbeddedServer::step() {
  if (!running_->thread.joinable()) running_->step();
}

ServerAddress EmbeddedServer::address() const { return {kLoopback, running_->server.port()}; }

std::size_t EmbeddedServer::clients() const { return running_->clients; }

bool EmbeddedServer::waits() const { return running_->waits; }

void EmbeddedServer::countTimes(bool count) { running_->timesCount = count; }

void EmbeddedServer::keepTimesOf(const SlotsByLocal& slots) {
  const std::lock_guard lock(running_->keptMutex);
  running_->kept = slots;
}

void EmbeddedServer::startNextLevel() { running_->nextAsked = true; }

CryptoKey EmbeddedServer::identity() const { return running_->server.identity().publicKey(); }

}  // namespace platon
