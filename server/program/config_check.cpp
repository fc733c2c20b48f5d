#include "server/program/config_check.h"

#include <cerrno>
#include <sstream>
#include <utility>

#include "protocol/program_error.h"
#include "protocol/transport/server_identity.h"
#include "protocol/transport/udp_socket.h"
#include "server/admin/announcement.h"
#include "server/admin/bans.h"
#include "server/admin/console_socket.h"
#include "server/admin/metrics.h"
#include "server/admin/stream_socket.h"
#include "server/app/level_files.h"
#include "server/times/best_times.h"

namespace platon {
namespace {

constexpr const char* kOtherSocket = "; ignore this if that program is this server, started with another --socket";

/// Collects what is wrong.
class Checker {
 public:
  void add(int exitCode, const std::string& lines) {
    check_.exitCode = exitCode == ProgramError::kUsage || check_.exitCode == 0 ? exitCode : check_.exitCode;
    std::istringstream stream(lines);
    for (std::string line; std::getline(stream, line);) check_.errors.push_back(line);
  }

  // Adds what `check` throws.
  template <class Check>
  void attempt(Check check) {
    try {
      check();
    } catch (const ProgramError& error) {
      add(error.exitCode(), error.what());
    }
  }

  // One by one, so that an unreadable file does not hide the errors of the next ones.
  void checkLevels(const std::vector<std::string>& paths) {
    for (const std::string& path : paths) {
      attempt([&] {
        const LoadedLevels loaded = loadLevelFiles({path});
        check_.errors.insert(check_.errors.end(), loaded.warnings.begin(), loaded.warnings.end());
      });
    }
    check_.summary = "levels: " + std::to_string(paths.size());
  }

  void checkBans(const std::string& path) {
    if (path.empty()) return;
    const auto read = readBanFile(path);
    if (const auto* list = std::get_if<BanList>(&read)) {
      check_.summary += ", bans: " + std::to_string(list->size());
      return;
    }
    for (const std::string& error : std::get<std::vector<std::string>>(read)) add(ProgramError::kUsage, error);
  }

  void checkBestTimes(const std::string& path) {
    if (path.empty()) return;
    const auto read = readBestTimes(path);
    if (const auto* times = std::get_if<BestTimes>(&read)) {
      check_.summary += ", best times: " + std::to_string(times->size());
      return;
    }
    for (const std::string& error : std::get<std::vector<std::string>>(read)) add(ProgramError::kUsage, error);
  }

  void checkSecrets(const ServerOptions& options) {
    attempt([&] {
      if (options.keyFile.empty()) return;
      if (!checkKeyFile(options.keyFile)) check_.summary += ", a key will be made in " + options.keyFile;
      const std::string warning = keyFileWarning(options.keyFile);
      if (!warning.empty()) check_.errors.push_back(options.keyFile + ": warning: " + warning);
    });
    attempt([&] {
      if (!options.passwordFile.empty()) readPasswordFile(options.passwordFile);
    });
  }

  void checkAnnouncement(const ServerOptions& options) {
    attempt([&] { (void)announcementOf(options.announce, options.announceAs, ServerIdentity::random()); });
  }

  // At any free port, because the server may be running.
  void checkAddresses(const ServerOptions& options) {
    attempt([&] { UdpSocket(options.bind, 0); });
    attempt([&] {
      if (!options.metrics.empty()) MetricsServer({parseSocketAddress(options.metrics)->ip, 0});
    });
    attempt([&] {
      if (!options.socket.empty()) checkConsolePath(options.socket);
    });
  }

  // A server that runs uses its ports itself. Where it cannot be told whether one does, nothing is said. One whose
  // `socket` has changed since its start cannot be told from another program.
  void checkPorts(const ServerOptions& options) {
    const Descriptor console = connectUnix(options.socket.empty() ? defaultConsolePath() : options.socket);
    if (console || (errno != ENOENT && errno != ECONNREFUSED)) return;
    warnIfUsed([&] { UdpSocket(options.bind, options.port); });
    warnIfUsed([&] {
      if (!options.metrics.empty()) MetricsServer(*parseSocketAddress(options.metrics));
    });
  }

  ConfigCheck take() { return std::move(check_); }

 private:
  // The next start may find the port free, so this is no error. `checkAddresses` tells what else is wrong.
  template <class Open>
  void warnIfUsed(Open open) {
    try {
      open();
    } catch (const ProgramError& error) {
      if (error.exitCode() == ProgramError::kFailed) {
        check_.errors.push_back(std::string("warning: ") + error.what() + kOtherSocket);
      }
    }
  }

  ConfigCheck check_;
};

}  // namespace

ConfigCheck checkConfig(const CommandLine& line) {
  Checker checker;
  const OptionsResult read = readOptions(line);
  for (const std::string& error : read.errors) checker.add(ProgramError::kUsage, error);
  const ServerOptions& options = read.options;
  checker.attempt([&] { checker.checkLevels(options.levels.empty() ? shippedLevelFiles() : options.levels); });
  checker.checkBans(options.banFile);
  checker.checkBestTimes(options.bestTimes);
  checker.checkSecrets(options);
  checker.checkAnnouncement(options);
  checker.checkAddresses(options);
  checker.checkPorts(options);
  return checker.take();
}

}  // namespace platon
