#include "client/play/embedded_server.h"

#include <atomic>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "client/play/user_folders.h"
#include "protocol/files/file_watch.h"
#include "protocol/label.h"
#include "protocol/limits.h"
#include "protocol/program_error.h"
#include "protocol/transport/udp_socket.h"
#include "server/app/dedicated_server.h"
#include "server/app/level_files.h"

namespace platon {

namespace {

constexpr const char* kLoopback = "127.0.0.1";

std::vector<LevelPointer> load(const std::vector<std::string>& files) {
  LoadedLevels loaded = loadLevelFiles(files);
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
  explicit Running(const std::vector<std::string>& files)
      : levelFiles(files),
        server(settings(), load(files), silentLog()),
        thread([this] { server.run([this] { return shouldStop(); }); }) {}
  ~Running() {
    stop = true;
    thread.join();
  }

  bool shouldStop() {
    if (levelFiles.poll(std::chrono::steady_clock::now())) reload();
    return stop;
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

  FileWatch levelFiles;
  DedicatedServer server;
  std::atomic<bool> stop{false};
  std::thread thread;  // last: uses the members above from its start
};

EmbeddedServer::EmbeddedServer(const std::string& levelFile) {
  try {
    running_ = std::make_unique<Running>(levelFile.empty() ? shippedLevelFiles() : std::vector{levelFile});
  } catch (const SocketError& error) {
    throw ProgramError(ProgramError::kFailed, error.what());
  }
}

EmbeddedServer::~EmbeddedServer() = default;

ServerAddress EmbeddedServer::address() const { return {kLoopback, running_->server.port()}; }

CryptoKey EmbeddedServer::identity() const { return running_->server.identity().publicKey(); }

}  // namespace platon
