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
#include "client/local/local_server.h"
#include "client/net/enet_link.h"
#include "protocol/files/file_watch.h"
#include "protocol/label.h"
#include "protocol/limits.h"
#include "protocol/program_error.h"
#include "protocol/transport/udp_socket.h"
#include "protocol/work/worker.h"
#include "server/app/dedicated_server.h"
#include "server/app/identity_file.h"
#include "server/app/level_files.h"
#include "server/times/best_times.h"

namespace platon {

namespace {

constexpr const char* kLoopback = "127.0.0.1";
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

MatchSettings matchSettings(const EmbeddedSettings& wanted) {
  MatchSettings settings;
  settings.serverName = "Platon";
  settings.maxPlayers = wanted.maxPlayers;
  settings.waitsForOne = wanted.waitsForOne;
  settings.keepsTimesOfOne = true;
  return settings;
}

ServerSettings serverSettings(const EmbeddedSettings& wanted) {
  ServerSettings settings;
  settings.bestTimes = keptBestTimes();
  settings.bind = wanted.bind;
  settings.port = wanted.port;
  settings.password = wanted.password;
  settings.start = LevelRotation::Start::kFirst;  // the player has chosen it
  settings.match = matchSettings(wanted);
  Log log = silentLog();
  settings.identity = loadIdentity("", log);
  return settings;
}

std::vector<std::string> filesOf(const EmbeddedSettings& settings) {
  return settings.levels.empty() ? gameLevelFiles() : settings.levels;
}

std::function<TimePoint()> nowOf(const std::shared_ptr<const PausableClock>& clock) {
  if (!clock) return steadyNow;
  return [clock] { return TimePoint(clock->now()); };
}

// A player chooses the port on a page, not by an option.
std::string listenFault(const EmbeddedSettings& settings, const SocketError& error) {
  constexpr std::uint16_t kFirstFree = 1024;
  const std::string port = "UDP port " + std::to_string(settings.port);
  if (error.exitCode() == SocketError::kFailed) return "Another program uses " + port + ": choose another port.";
  if (settings.port < kFirstFree) return "The game may not use " + port + ": choose a port above 1023.";
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

// Whoever plays the only level while it is made sees each version at once.
void reload(const std::vector<std::string>& files, Match& match) {
  try {
    match.updateLevels(load(files));
    if (files.size() == 1) match.startNextRound();
  } catch (const ProgramError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    match.say(noticeOf(files.front(), error.what()));
  }
}

// For the clients of this program alone.
class PrivateServer final : public OwnServer {
 public:
  PrivateServer(const EmbeddedSettings& settings, const std::shared_ptr<const PausableClock>& clock)
      : clock_(clock),
        levelFiles_(filesOf(settings)),
        bestTimes_(bestTimesOf(keptBestTimes())),
        server_(matchSettings(settings), load(levelFiles_.files()), &bestTimes_, clock->now()) {}
  ~PrivateServer() override { tell(bestTimes_.finish()); }

  void step() override {
    const auto real = std::chrono::steady_clock::now();
    if (levelFiles_.poll(real)) reload(levelFiles_.files(), server_.match());
    server_.update(clock_->now());
    tell(bestTimes_.poll(real));
  }
  ServerLinks links() override { return server_.links(); }
  ServerKnowledge knowledge() const override { return {}; }
  std::optional<std::uint16_t> port() const override { return std::nullopt; }
  std::size_t clients() const override { return server_.match().clients(); }
  bool waits() const override { return server_.match().waits(); }
  void countTimes(bool count) override { server_.match().countTimes(count); }
  void keepTimesOf(const SlotsByLocal& slots) override { server_.match().keepTimesOf(slots); }
  void startNextLevel() override { server_.match().startNextRound(); }

 private:
  static void tell(const std::optional<std::string>& fault) {
    if (fault) std::fprintf(stderr, "platon-client: best times not written: %s\n", fault->c_str());
  }

  std::shared_ptr<const PausableClock> clock_;
  FileWatch levelFiles_;
  BestTimeStore bestTimes_;
  LocalServer server_;
};

}  // namespace

std::unique_ptr<OwnServer> startServer(const EmbeddedSettings& settings,
                                       const std::shared_ptr<const PausableClock>& clock) {
  if (settings.listens) return std::make_unique<EmbeddedServer>(settings, clock);
  return std::make_unique<PrivateServer>(settings, clock);
}

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
    if (levelFiles.poll(std::chrono::steady_clock::now())) reload(levelFiles.files(), server.match());
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

EmbeddedServer::EmbeddedServer(const EmbeddedSettings& settings, const std::shared_ptr<const PausableClock>& clock)
    : password_(settings.password) {
  try {
    running_ = std::make_unique<Running>(settings, filesOf(settings), clock);
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

ServerLinks EmbeddedServer::links() { return enetLinks(address()); }

ServerKnowledge EmbeddedServer::knowledge() const { return {running_->server.identity().publicKey(), password_}; }

std::optional<std::uint16_t> EmbeddedServer::port() const { return running_->server.port(); }

}  // namespace platon
