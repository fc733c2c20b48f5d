#include "client/play/embedded_server.h"

#include <atomic>
#include <cstdio>
#include <filesystem>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "client/play/user_folders.h"
#include "protocol/program_error.h"
#include "protocol/transport/udp_socket.h"
#include "server/app/dedicated_server.h"
#include "server/app/level_files.h"

namespace platon {

namespace {

constexpr const char* kLoopback = "127.0.0.1";

std::vector<LevelPointer> load(const std::string& levelFile) {
  LoadedLevels loaded = loadLevelFiles(levelFile.empty() ? shippedLevelFiles() : std::vector<std::string>{levelFile});
  for (const std::string& warning : loaded.warnings) std::fprintf(stderr, "%s\n", warning.c_str());
  return std::move(loaded.levels);
}

// Without a folder, best times end with the server.
std::string bestTimesFile() {
  const std::filesystem::path folder = dataFolder();
  if (folder.empty()) return {};
  std::error_code fault;
  std::filesystem::create_directories(folder, fault);
  return fault ? std::string() : (folder / "best_times").string();
}

ServerSettings settings() {
  ServerSettings settings;
  settings.bestTimes = bestTimesFile();
  settings.bind = kLoopback;
  settings.port = 0;
  settings.match.serverName = "Platon";
  return settings;
}

// The messages are for the operator of a server; a player needs none of them.
Log silentLog() {
  return Log(LogFormat::kText, [](std::string_view) {});
}

}  // namespace

struct EmbeddedServer::Running {
  explicit Running(std::vector<LevelPointer> levels)
      : server(settings(), std::move(levels), silentLog()),
        thread([this] { server.run([this] { return stop.load(); }); }) {}
  ~Running() {
    stop = true;
    thread.join();
  }

  DedicatedServer server;
  std::atomic<bool> stop{false};
  std::thread thread;  // last: uses the members above from its start
};

EmbeddedServer::EmbeddedServer(const std::string& levelFile) {
  try {
    running_ = std::make_unique<Running>(load(levelFile));
  } catch (const SocketError& error) {
    throw ProgramError(ProgramError::kFailed, error.what());
  }
}

EmbeddedServer::~EmbeddedServer() = default;

ServerAddress EmbeddedServer::address() const { return {kLoopback, running_->server.port()}; }

CryptoKey EmbeddedServer::identity() const { return running_->server.identity().publicKey(); }

}  // namespace platon
